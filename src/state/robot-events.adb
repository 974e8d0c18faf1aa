--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time; use Ada.Real_Time;
with Event;
with Schedule;
with Trace;

package body Robot.Events with SPARK_Mode is

   package For_Battery is new Event;
   package For_Keep_Alive is new Event;
   package For_Reload is new Event;

   procedure Started (With_Watchdog : Boolean) is
   begin
      if With_Watchdog then
         Trace.Release (Schedule.Th_Reload_WD);
         For_Reload.Set;
      end if;
      Trace.Release (Schedule.Th_Battery_Level);
      For_Battery.Set;
      Trace.Release (Schedule.Th_Keep_Alive);
      For_Keep_Alive.Set;
   end Started;

   procedure Wait_Battery is
   begin
      Trace.Done (Schedule.Th_Battery_Level);
      For_Battery.Wait;
      Trace.Start (Schedule.Th_Battery_Level);
   end Wait_Battery;

   procedure Wait_Keep_Alive is
      Until_Ping : Time;
      Was_Set    : Boolean;
   begin
      Trace.Done (Schedule.Th_Keep_Alive);
      Until_Ping := Clock;
      Until_Ping := Until_Ping + Schedule.Idle_Ping_Period;
      For_Keep_Alive.Wait_Until (Until_Ping, Was_Set);
      if Was_Set then
         Trace.Start (Schedule.Th_Keep_Alive);
      else
         Trace.Start (Schedule.Th_Keep_Alive, Until_Ping);
      end if;
   end Wait_Keep_Alive;

   procedure Wait_Reload is
   begin
      Trace.Done (Schedule.Th_Reload_WD);
      For_Reload.Wait;
      Trace.Start (Schedule.Th_Reload_WD);
   end Wait_Reload;

end Robot.Events;
