--  SPDX-License-Identifier: GPL-3.0-or-later
--  The event by which a task learns that it may take the robot's line.

with Ada.Real_Time;
with Orders;
with Schedule;

generic
   Who : Schedule.Task_Name;
package Robot.Turns with SPARK_Mode is

   procedure Signal (Number : Orders.Ticket := 0)
   with Annotate => (GNATprove, Terminating);
   --  Who may take the line, or is to look when it will. Number: of the
   --  monitor's order that Who is to carry out, if any

   procedure Wait;
   --  Ends a job of Who, and waits for Signal

   procedure Wait_Until (At_Time : Ada.Real_Time.Time; Was_Set : out Boolean);
   --  The same, but At_Time begins a job, too (not Was_Set)

   procedure Wait_In_Job;
   --  Waits for Signal in the middle of a job

end Robot.Turns;
