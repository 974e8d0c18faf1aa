--  SPDX-License-Identifier: GPL-3.0-or-later
--  The event "the robot has started", one for each periodic robot task.

with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;

package body Robot_Events with SPARK_Mode is

   For_Battery    : Suspension_Object;
   For_Keep_Alive : Suspension_Object;
   For_Reload     : Suspension_Object;

   -------------
   -- Started --
   -------------

   procedure Started (With_Watchdog : Boolean) is
   begin
      if With_Watchdog then
         Set_True (For_Reload);
      end if;
      Set_True (For_Battery);
      Set_True (For_Keep_Alive);
   end Started;

   ------------------
   -- Wait_Battery --
   ------------------

   procedure Wait_Battery is
   begin
      Suspend_Until_True (For_Battery);
   end Wait_Battery;

   ---------------------
   -- Wait_Keep_Alive --
   ---------------------

   procedure Wait_Keep_Alive is
   begin
      Suspend_Until_True (For_Keep_Alive);
   end Wait_Keep_Alive;

   -----------------
   -- Wait_Reload --
   -----------------

   procedure Wait_Reload is
   begin
      Suspend_Until_True (For_Reload);
   end Wait_Reload;

end Robot_Events;
