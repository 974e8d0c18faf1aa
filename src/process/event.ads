--  SPDX-License-Identifier: GPL-3.0-or-later
--  An event that the task Who waits for, and what the trace records of it.
--  GNAT's suspension objects have a mutex without a ceiling: a task that is
--  pre-empted while it holds one delays a more urgent task for as long as the
--  tasks between them run. An event counter of the kernel has no such mutex.

with Ada.Real_Time;
with Commands;
with Schedule;
with Trace;

generic
   Who : Schedule.Thread_Name;
package Event with SPARK_Mode is

   procedure Set (Number : Commands.Ticket := 0)
   with Annotate => (GNATprove, Terminating);
   --  Does not block. Several times before the next Wait count as once.
   --  Number: of the monitor's command that Who is to carry out, if any

   procedure Wait;
   --  Until the event has been set since the last Wait: ends a job of Who, and
   --  begins the next. GNATprove refuses a second task that waits, and a wait
   --  inside a protected action

   procedure Wait_Until (At_Time : Ada.Real_Time.Time; Was_Set : out Boolean);
   --  The same, but At_Time ends the wait, too (not Was_Set). An event that
   --  has been set is taken even after At_Time

   procedure Wait_In_Job (Why : Trace.Label_Text);
   --  The same as Wait, but in the middle of a job

end Event;
