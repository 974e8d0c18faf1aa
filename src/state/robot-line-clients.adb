--  SPDX-License-Identifier: GPL-3.0-or-later

with Event;
with Trace;

package body Robot.Line.Clients with SPARK_Mode is

   package Finished is new Event;

   procedure Wait;
   --  Until the request has been carried out

   procedure Ask (Order : in out Orders.Order) is
   begin
      Robot.Line.Put (Who, Order);
      Wait;
   end Ask;

   procedure Ask
     (Request : Robot.Session.Request; Result : out Robot.Session.Outcome) is
   begin
      Robot.Line.Put (Who, Request);
      Wait;
      Robot.Line.Collect (Who, Result);
   end Ask;

   procedure Ask
     (Run     : Robot.Line_Status.Status;
      Request : Robot.Session.Request;
      Result  : out Robot.Session.Outcome)
   is
      Same : Boolean;
   begin
      Robot.Line.Put_In_Run (Who, Request, Run, Same);
      if Same then
         Wait;
         Robot.Line.Collect (Who, Result);
      else
         Result := (Kind => Robot.Session.Not_Open, others => <>);
      end if;
   end Ask;

   procedure Ask_For_Mission
     (Request : Robot.Session.Request;
      Order   : Orders.Order;
      Result  : out Robot.Session.Outcome) is
   begin
      Robot.Line.Put_For_Mission (Request, Order);
      Wait;
      Robot.Line.Collect (Who, Result);
   end Ask_For_Mission;

   procedure Signal is
   begin
      Trace.Release (Its_Task);
      Finished.Set;
   end Signal;

   procedure Wait is
   begin
      Trace.Wait (Its_Task, Trace.Line);
      Finished.Wait;
      Trace.Resume (Its_Task);
   end Wait;

end Robot.Line.Clients;
