--  SPDX-License-Identifier: GPL-3.0-or-later

with Event;
with Trace;

package body Robot.Turns with SPARK_Mode is

   package Granted is new Event;

   procedure Signal (Number : Orders.Ticket := 0) is
   begin
      Trace.Release (Who, Number);
      Granted.Set;
   end Signal;

   procedure Wait is
   begin
      Trace.Done (Who);
      Granted.Wait;
   end Wait;

   procedure Wait_Until (At_Time : Ada.Real_Time.Time; Was_Set : out Boolean)
   is
   begin
      Trace.Done (Who);
      Granted.Wait_Until (At_Time, Was_Set);
      if not Was_Set then
         Trace.Start (Who, At_Time);
      end if;
   end Wait_Until;

   procedure Wait_In_Job is
   begin
      Trace.Wait (Who, Trace.Line);
      Granted.Wait;
      Trace.Resume (Who);
   end Wait_In_Job;

end Robot.Turns;
