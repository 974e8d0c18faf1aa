--  SPDX-License-Identifier: GPL-3.0-or-later
--  The requests that wait for the robot's line, and the known state of the
--  robot, shared by all tasks.

with Ada.Real_Time;
with Orders;
with Robot.Line_Status;
with Robot.Requests;
with Robot.Session;

package Robot.Line with SPARK_Mode is

   use type Orders.Ticket;
   use type Robot.Requests.Client;

   procedure Begin_Session (First : Orders.Ticket)
   with Annotate => (GNATprove, Terminating);
   --  Orders with a lower number are out of date from now on

   procedure Refuse_Orders with Annotate => (GNATprove, Terminating);
   --  The process ends: all orders are out of date from now on

   procedure Put
     (From : Robot.Requests.Single; Request : Robot.Session.Request)
   with Annotate => (GNATprove, Terminating);
   --  A request of From's own

   procedure Put_In_Run
     (From    : Robot.Requests.Single;
      Request : Robot.Session.Request;
      Run     : Robot.Line_Status.Status;
      Same    : out Boolean)
   with Annotate => (GNATprove, Terminating);
   --  The same, unless the robot's run that Run is of has ended (not Same)

   procedure Put
     (From : Robot.Requests.Single; Order : in out Orders.Order)
   with
     Pre  => Order.Owed,
     Post => not Order.Owed,
     Annotate => (GNATprove, Terminating);
   --  An order of the monitor from From; the line's owner answers it

   procedure Put_Stop (Order : in out Orders.Order)
   with
     Pre  => Order.Owed,
     Post => not Order.Owed,
     Annotate => (GNATprove, Terminating);
   --  A monitor's stop. It cancels older movements that still wait

   procedure Put_For_Mission
     (Request : Robot.Session.Request; Order : Orders.Order)
   with
     Pre => not Order.Owed,
     Annotate => (GNATprove, Terminating);
   --  A request of the mission that Order has asked for

   procedure Note_Hand (Number : Orders.Ticket)
   with Annotate => (GNATprove, Terminating);
   --  Order Number is one by hand, and about to be passed on: missions that
   --  are older ask the robot for nothing any more

   procedure Set_Reload_Due (At_Time : Ada.Real_Time.Time)
   with Annotate => (GNATprove, Terminating);
   --  Shortly before this time only a stop or a movement may start

   procedure Take (Next : in out Robot.Requests.Job)
   with
     Pre  => not Next.Order.Owed,
     Post => Next.Order.Owed =
       (Next.Order.Number /= 0
        and then Next.From /= Robot.Requests.Mission);
   --  The most urgent request; waits for one. For the owner of the line only

   procedure Finish
     (Done    : Robot.Requests.Job;
      Held    : Robot.Line_Status.Dialogue;
      Result  : Robot.Session.Outcome;
      At_Time : Ada.Real_Time.Time)
   with Annotate => (GNATprove, Terminating);
   --  Request Done has ended with Result, the robot's dialogue as in Held

   procedure Collect
     (From : Robot.Requests.Client; Result : out Robot.Session.Outcome)
   with Annotate => (GNATprove, Terminating);
   --  The outcome of the last request of From

   procedure Get_Status (Current : out Robot.Line_Status.Status)
   with Annotate => (GNATprove, Terminating);

   procedure Get_Rights
     (Number : Orders.Ticket; Is_Over, By_Hand : out Boolean)
   with Annotate => (GNATprove, Terminating);
   --  Is_Over: the session of order Number has ended. By_Hand: an order by
   --  hand has come after it

end Robot.Line;
