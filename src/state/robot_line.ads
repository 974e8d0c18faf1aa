--  SPDX-License-Identifier: GPL-3.0-or-later
--  The requests that wait for the robot's line, and what is known of the
--  robot. Urgency decides: the end of a session, a stop, the reload of the
--  watchdog, a movement, then the rest.

with Ada.Real_Time;
with Line_Requests;
with Orders;
with Robot_Session;

package Robot_Line with SPARK_Mode is

   type Status is record
      Open       : Boolean := False;
      Mode       : Robot_Session.Mode_Kind := Robot_Session.Not_Started;
      Epoch      : Natural := 0;
      --  grows by one at each start
      Started_At : Ada.Real_Time.Time := Ada.Real_Time.Time_First;
      --  when the robot acknowledged the last start
      Used_At    : Ada.Real_Time.Time := Ada.Real_Time.Time_First;
      --  the end of the last exchange
   end record;

   procedure Begin_Session (First : Orders.Ticket)
   with Annotate => (GNATprove, Terminating);
   --  Orders with a lower number are out of date from now on

   procedure Refuse_Orders;
   --  All orders are out of date from now on: the process ends

   procedure Put
     (From    : Line_Requests.Single;
      Request : Robot_Session.Request;
      Order   : Orders.Order := (others => <>))
   with Annotate => (GNATprove, Terminating);
   --  From has a request. Order: the monitor's, if it stands behind it

   procedure Put_Stop (Order : Orders.Order)
   with Annotate => (GNATprove, Terminating);
   --  A monitor's stop. Movements that are still waiting and are older
   --  become void

   procedure Set_Reload_Due (At_Time : Ada.Real_Time.Time)
   with Annotate => (GNATprove, Terminating);
   --  Shortly before this time nothing but a stop or a movement is begun

   procedure Take (Next : out Line_Requests.Job; Found : out Boolean);
   --  The most urgent request; waits for one. Found is false where it must
   --  wait until the reload is done. For the owner of the line only

   procedure Finish
     (Done    : Line_Requests.Job;
      State   : Robot_Session.State;
      Result  : Robot_Session.Outcome;
      At_Time : Ada.Real_Time.Time)
   with Annotate => (GNATprove, Terminating);
   --  Result has come of Done, and State is the session's now

   procedure Collect
     (From : Line_Requests.Client; Result : out Robot_Session.Outcome)
   with Annotate => (GNATprove, Terminating);
   --  What came of the last request of From

   procedure Get_Status (Current : out Status)
   with Annotate => (GNATprove, Terminating);

end Robot_Line;
