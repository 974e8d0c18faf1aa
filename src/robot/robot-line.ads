--  SPDX-License-Identifier: GPL-3.0-or-later
--  The robot's line: requests wait for it, and it is granted to one task at a
--  time, with the dialogue with the robot.

with Ada.Real_Time; use Ada.Real_Time;
with Commands;
with Event;
with Robot.Line_Status;
with Robot.Requests;
with Schedule; use Schedule;

package Robot.Line with SPARK_Mode is

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

   type Turn is record
      To     : Thread_Name := Main;
      Number : Commands.Ticket := 0;
   end record;
   --  The task that is to be woken, as the line is free for its request; Main:
   --  none. Number: of the monitor's order, if it is one

   protected Grant with Priority => Schedule.Line_Ceiling is

      procedure Begin_Session (First : Commands.Ticket);
      --  Orders with a lower number are out of date from now on. Ticket'Last,
      --  as the process ends: all orders

      procedure Take
        (Who     : Task_Name;
         Item    : in out Requests.Job;
         Verdict : out Requests.Verdict_Kind;
         Held    : out Line_Status.Dialogue;
         Found   : out Boolean);
      --  Found: the line is granted to Who until Finish, for Item. Otherwise
      --  something else has come that is more urgent: Who is woken again

      procedure Get_Status (Current : out Line_Status.Status);

      procedure Get_Rights
        (Number : Commands.Ticket; Is_Over, By_Hand : out Boolean);
      --  Is_Over: the session of order Number has ended. By_Hand: an order by
      --  hand has come after it

      --  For the procedures below, which wake the task of Next

      procedure Put (Item : Requests.Job; Next : out Turn);
      procedure Look
        (From : Requests.Periodic; Due : out Time; Next : out Turn);
      procedure Finish
        (Done   : Requests.Job;
         Held   : Line_Status.Dialogue;
         Result : Commands.Outcome;
         Next   : out Turn);

   private
      Waiting : Requests.Requests;
      State   : Line_Status.Status;
      Asked   : Time := Time_First;
      --  when the mission made its last request
   end Grant;

   procedure Put (Order : in out Commands.Order)
   with
     Pre  => Order.Owed and then Order.Command.Name in Commands.Robot_Command,
     Post => not Order.Owed,
     Annotate => (GNATprove, Terminating);
   --  The monitor's order, which the task of Commands.Table carries out and
   --  answers. There is always room: no more orders are in progress than wait
   --  here

   procedure Ask
     (From    : Requests.Asked;
      Request : Commands.Request;
      Order   : Commands.Order)
   with
     Pre => not Order.Owed,
     Annotate => (GNATprove, Terminating);
   --  A request of From itself; Order: that has asked for the mission, if it
   --  is one

   procedure Look (From : Requests.Periodic; Next : out Time)
   with Annotate => (GNATprove, Terminating);
   --  If something may start by now, its task is woken. Next: when to look
   --  again, for From

   procedure Finish
     (Done   : Requests.Job;
      Held   : Line_Status.Dialogue;
      Result : Commands.Outcome)
   with Annotate => (GNATprove, Terminating);
   --  Request Done has ended with Result, the robot's dialogue as in Held:
   --  gives the line back, for the next one

end Robot.Line;
