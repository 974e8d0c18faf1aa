--  SPDX-License-Identifier: GPL-3.0-or-later
--  The event "the robot has started", one for each periodic robot task.

package Robot.Events with SPARK_Mode is

   procedure Started (With_Watchdog : Boolean)
   with Annotate => (GNATprove, Terminating);

   procedure Wait_Battery;
   --  For th_batteryLevel only
   procedure Wait_Keep_Alive;
   --  Until a start, or for an Idle_Ping_Period. For th_keepAlive only
   procedure Wait_Reload;
   --  After a start with watchdog. For th_reloadWD only

end Robot.Events;
