--  SPDX-License-Identifier: GPL-3.0-or-later
--  The event "the robot has started", one for each periodic robot task.

with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with Schedule;
with Trace;

package body Robot.Events with SPARK_Mode is

   For_Battery    : Suspension_Object;
   For_Keep_Alive : Suspension_Object;
   For_Reload     : Suspension_Object;

   procedure Started (With_Watchdog : Boolean) is
   begin
      if With_Watchdog then
         Trace.Release (Schedule.Th_Reload_WD);
         Set_True (For_Reload);
      end if;
      Trace.Release (Schedule.Th_Battery_Level);
      Set_True (For_Battery);
      Trace.Release (Schedule.Th_Keep_Alive);
      Set_True (For_Keep_Alive);
   end Started;

   procedure Wait_Battery is
   begin
      Trace.Done (Schedule.Th_Battery_Level);
      Suspend_Until_True (For_Battery);
      Trace.Start (Schedule.Th_Battery_Level);
   end Wait_Battery;

   procedure Wait_Keep_Alive is
   begin
      Trace.Done (Schedule.Th_Keep_Alive);
      Suspend_Until_True (For_Keep_Alive);
      Trace.Start (Schedule.Th_Keep_Alive);
   end Wait_Keep_Alive;

   procedure Wait_Reload is
   begin
      Trace.Done (Schedule.Th_Reload_WD);
      Suspend_Until_True (For_Reload);
      Trace.Start (Schedule.Th_Reload_WD);
   end Wait_Reload;

end Robot.Events;
