--  SPDX-License-Identifier: GPL-3.0-or-later

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
   begin
      Trace.Done (Schedule.Th_Keep_Alive);
      For_Keep_Alive.Wait;
      Trace.Start (Schedule.Th_Keep_Alive);
   end Wait_Keep_Alive;

   procedure Wait_Reload is
   begin
      Trace.Done (Schedule.Th_Reload_WD);
      For_Reload.Wait;
      Trace.Start (Schedule.Th_Reload_WD);
   end Wait_Reload;

end Robot.Events;
