--  SPDX-License-Identifier: GPL-3.0-or-later
--  The robot's line: requests wait for it, and it is granted to one task at a
--  time, with the dialogue with the robot.

with Ada.Real_Time;
with Commands;
with Event;
with Robot.Line_Status;
with Robot.Requests;
with Schedule; use Schedule;

package Robot.Line with SPARK_Mode is

   use type Commands.Ticket;
   use type Robot.Requests.Source;

   --  The events by which each of the tasks that use the line learns that it
   --  may take it, or is to look when it will

   package Open_Com is new Event (Th_Open_Com_Robot);
   package Start is new Event (Th_Start_Robot);
   package Start_WD is new Event (Th_Start_Robot_WD);
   package Reset is new Event (Th_Reset_Robot);
   package Move is new Event (Th_Move);
   package Battery is new Event (Th_Battery_Level);
   package Mission is new Event (Th_Mission);
   package Monitor_Lost is new Event (Th_Com_Mon_Perdue);

   procedure Begin_Session (First : Commands.Ticket)
   with Annotate => (GNATprove, Terminating);
   --  Orders with a lower number are out of date from now on. Ticket'Last, as
   --  the process ends: all orders

   procedure Put (Order : in out Commands.Order)
   with
     Pre  => Order.Owed and then Order.Command.Name in Commands.Robot_Command,
     Post => not Order.Owed,
     Annotate => (GNATprove, Terminating);
   --  The monitor's order, which the task of Commands.Table carries out and
   --  answers. There is always room: no more orders are in progress than wait
   --  here

   procedure Ask
     (From    : Robot.Requests.Asked;
      Request : Commands.Request;
      Order   : Commands.Order)
   with
     Pre => not Order.Owed,
     Annotate => (GNATprove, Terminating);
   --  A request of From itself; Order: that has asked for the mission, if it
   --  is one

   procedure Look
     (From : Robot.Requests.Periodic; Next : out Ada.Real_Time.Time)
   with Annotate => (GNATprove, Terminating);
   --  If something may start by now, its task is woken. Next: when to look
   --  again, for From

   procedure Take
     (Who     : Task_Name;
      Item    : in out Robot.Requests.Job;
      Verdict : out Robot.Requests.Verdict_Kind;
      Held    : out Robot.Line_Status.Dialogue;
      Found   : out Boolean)
   with
     Pre  => not Item.Order.Owed,
     Post => Item.Order.Owed =
       (Found
        and then Item.Order.Number /= 0
        and then Item.From /= Robot.Requests.Mission),
     Annotate => (GNATprove, Terminating);
   --  Found: the line is granted to Who until Finish, for Item. Otherwise
   --  something else has come that is more urgent: Who is woken again

   procedure Finish
     (Done   : Robot.Requests.Job;
      Held   : Robot.Line_Status.Dialogue;
      Result : Commands.Outcome)
   with Annotate => (GNATprove, Terminating);
   --  Request Done has ended with Result, the robot's dialogue as in Held:
   --  gives the line back, for the next one

   procedure Get_Status (Current : out Robot.Line_Status.Status)
   with Annotate => (GNATprove, Terminating);

   procedure Get_Rights
     (Number : Commands.Ticket; Is_Over, By_Hand : out Boolean)
   with Annotate => (GNATprove, Terminating);
   --  Is_Over: the session of order Number has ended. By_Hand: an order by
   --  hand has come after it

end Robot.Line;
