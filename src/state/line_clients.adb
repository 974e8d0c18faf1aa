--  SPDX-License-Identifier: GPL-3.0-or-later
--  One client of the robot's line: asks, and waits for what comes of it.

with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with Robot_Line;
with Trace;

package body Line_Clients with SPARK_Mode is

   Finished : Suspension_Object;

   ---------
   -- Ask --
   ---------

   procedure Ask
     (Request : Robot_Session.Request;
      Order   : Orders.Order;
      Result  : out Robot_Session.Outcome) is
   begin
      Robot_Line.Put (Who, Request, Order);
      Trace.Wait (Its_Task, Trace.Line);
      Suspend_Until_True (Finished);
      Trace.Resume (Its_Task);
      Robot_Line.Collect (Who, Result);
   end Ask;

   procedure Ask (Request : Robot_Session.Request) is
   begin
      Robot_Line.Put (Who, Request);
      Trace.Wait (Its_Task, Trace.Line);
      Suspend_Until_True (Finished);
      Trace.Resume (Its_Task);
   end Ask;

   ------------
   -- Signal --
   ------------

   procedure Signal is
   begin
      Trace.Release (Its_Task);
      Set_True (Finished);
   end Signal;

end Line_Clients;
