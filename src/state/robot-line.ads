--  SPDX-License-Identifier: GPL-3.0-or-later
--  The requests that wait for the robot's line, and what is known of the
--  robot, shared by all tasks.

with Ada.Real_Time;
with Orders;
with Robot.Line_Status;
with Robot.Requests;
with Robot.Session;

package Robot.Line with SPARK_Mode is

   use type Orders.Ticket;

   procedure Begin_Session (First : Orders.Ticket)
   with Annotate => (GNATprove, Terminating);
   --  Orders with a lower number are out of date from now on

   procedure Refuse_Orders with Annotate => (GNATprove, Terminating);
   --  All orders are out of date from now on: the process ends

   procedure Put
     (From : Robot.Requests.Single; Request : Robot.Session.Request)
   with Annotate => (GNATprove, Terminating);
   --  From has a request of its own

   procedure Put
     (From : Robot.Requests.Single; Order : in out Orders.Order)
   with
     Pre  => Order.Owed,
     Post => not Order.Owed,
     Annotate => (GNATprove, Terminating);
   --  From has the monitor's order, which the owner of the line answers

   procedure Put_Stop (Order : in out Orders.Order)
   with
     Pre  => Order.Owed,
     Post => not Order.Owed,
     Annotate => (GNATprove, Terminating);
   --  A monitor's stop. Movements that are still waiting and are older
   --  become void

   procedure Set_Reload_Due (At_Time : Ada.Real_Time.Time)
   with Annotate => (GNATprove, Terminating);
   --  Shortly before this time nothing but a stop or a movement is begun

   procedure Take (Next : in out Robot.Requests.Job)
   with
     Pre  => not Next.Order.Owed,
     Post => Next.Order.Owed = (Next.Order.Number /= 0);
   --  The most urgent request; waits for one. For the owner of the line only

   procedure Finish
     (Done    : Robot.Requests.Job;
      State   : Robot.Session.State;
      Result  : Robot.Session.Outcome;
      At_Time : Ada.Real_Time.Time)
   with Annotate => (GNATprove, Terminating);
   --  Result has come of Done, and State is the session's now

   procedure Collect
     (From : Robot.Requests.Client; Result : out Robot.Session.Outcome)
   with Annotate => (GNATprove, Terminating);
   --  What came of the last request of From

   procedure Get_Status (Current : out Robot.Line_Status.Status)
   with Annotate => (GNATprove, Terminating);

end Robot.Line;
