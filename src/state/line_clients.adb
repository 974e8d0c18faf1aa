--  SPDX-License-Identifier: GPL-3.0-or-later
--  One client of the robot's line: asks, and waits for what comes of it.

with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with Robot_Line;
with Trace;

package body Line_Clients with SPARK_Mode is

   Finished : Suspension_Object;

   procedure Wait;
   --  Until the request has been carried out

   ---------
   -- Ask --
   ---------

   procedure Ask (Order : in out Orders.Order) is
   begin
      Robot_Line.Put (Who, Order);
      Wait;
   end Ask;

   procedure Ask
     (Request : Robot_Session.Request; Result : out Robot_Session.Outcome) is
   begin
      Robot_Line.Put (Who, Request);
      Wait;
      Robot_Line.Collect (Who, Result);
   end Ask;

   ------------
   -- Signal --
   ------------

   procedure Signal is
   begin
      Trace.Release (Its_Task);
      Set_True (Finished);
   end Signal;

   ----------
   -- Wait --
   ----------

   procedure Wait is
   begin
      Trace.Wait (Its_Task, Trace.Line);
      Suspend_Until_True (Finished);
      Trace.Resume (Its_Task);
   end Wait;

end Line_Clients;
