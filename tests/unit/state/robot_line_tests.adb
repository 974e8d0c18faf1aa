--  SPDX-License-Identifier: GPL-3.0-or-later
--  The line's requests: urgency, void movements, places kept, missions.

with AUnit.Assertions; use AUnit.Assertions;

with Ada.Real_Time;
with Commands;         use Commands;
with Orders;           use Orders;
with Robot.Line;
with Robot.Line_Status;
with Robot.Requests;   use Robot.Requests;
with Robot.Session;
with Schedule;
with Unit_Runs; use Unit_Runs;

package body Robot_Line_Tests is

   procedure Ask
     (From        : Client;
      Name        : Command_Name;
      Number      : Ticket;
      Rank, After : Ticket := 0)
   is
      --  The monitor's order, by way of From.
      Order : Orders.Order :=
        (Number, (Name => Name, others => <>), Rank, After, Owed => True);
   begin
      Robot.Line.Put (From, Order);
   end Ask;

   procedure Ask (From : Client; Kind : Robot.Session.Request_Kind) is
      --  A request of From's own.
   begin
      Robot.Line.Put
        (From, Robot.Session.Request'(Kind => Kind, others => <>));
   end Ask;

   procedure Ask_For_Mission
     (Kind   : Robot.Session.Request_Kind;
      Number : Ticket;
      After  : Ticket := 0) is
      --  What the mission asks for that the monitor's order Number began.
   begin
      Robot.Line.Put_For_Mission
        ((Kind => Kind, others => <>),
         (Number => Number, After => After, others => <>));
   end Ask_For_Mission;

   procedure Check
     (From    : Client;
      Verdict : Verdict_Kind := Carry_Out;
      Mode    : Robot.Session.Mode_Kind := Robot.Session.Not_Started)
   is
      --  The next job is From's, and is done; then the robot is in Mode
      Next : Job;
   begin
      Robot.Line.Take (Next);
      Assert (Next.From = From,
              From'Image & " expected, not " & Next.From'Image);
      Assert (Next.Verdict = Verdict, From'Image & Next.Verdict'Image);
      Assert (not (Next.Order.Owed and then From = Mission),
              "a mission's order is answered when it begins, not here");
      Robot.Line.Finish
        (Next,
         (State   => (Line_Open => True, Mode => Mode, others => <>),
          Counted => Ada.Real_Time.Clock,
          others  => <>),
         (others => <>), Ada.Real_Time.Clock);
   end Check;

   procedure Stop (Number : Ticket; After : Ticket := 0) is
      Order : Orders.Order :=
        (Number, (Name => Stop_Robot, others => <>), 0, After, Owed => True);
   begin
      Robot.Line.Put_Stop (Order);
   end Stop;

   procedure Test_Many_Stops is
   begin
      Robot.Line.Begin_Session (400);
      Ask (Reload, Robot.Session.Reload);
      Ask (Move, Go_Forward, 399, 0, 0);
      for Number in Orders.Ticket range 400 .. 402 loop
         Stop (Number);
      end loop;
      Check (Stop_Order);
      Check (Reload);
      Check (Stop_Order);
      --  nothing else goes before a stop
      Check (Stop_Order);
      Check (Move, Out_Of_Date);
   end Test_Many_Stops;

   procedure Test_Hand is
   begin
      Robot.Line.Begin_Session (600);
      Ask_For_Mission (Robot.Session.Drive, 600);
      Robot.Line.Note_Hand (601);
      Check (Mission, Overtaken);
      --  nor is what it asks for later, a stop included

      Ask_For_Mission (Robot.Session.Get_Moving, 600);
      Check (Mission, Overtaken);
      Ask_For_Mission (Robot.Session.Stop, 600);
      Check (Mission, Overtaken);

      Ask_For_Mission (Robot.Session.Drive, 602);
      Check (Mission);

      Ask_For_Mission (Robot.Session.Stop, 602);
      Robot.Line.Begin_Session (603);
      Check (Mission, Out_Of_Date);
   end Test_Hand;

   procedure Test_Late is

      procedure Pass_Limit is
         use Ada.Real_Time;
      begin
         delay until Clock + Schedule.Mission_Order_Limit + Milliseconds (5);
      end Pass_Limit;

   begin
      Robot.Line.Begin_Session (700);
      Ask_For_Mission (Robot.Session.Drive, 700);
      Pass_Limit;
      Check (Mission, Late);
      Ask_For_Mission (Robot.Session.Stop, 700);
      Pass_Limit;
      Check (Mission);
      Ask_For_Mission (Robot.Session.Drive, 700);
      Check (Mission);
   end Test_Late;

   procedure Test_Mission_In_Turn is
   begin
      Robot.Line.Begin_Session (800);
      Ask_For_Mission (Robot.Session.Stop, 802, After => 2);
      Ask (Reset, Reset_Robot, 801, 2, 1);
      Ask (Open, Open_Robot, 800, 1, 0);
      Check (Open);
      Check (Reset);
      Check (Mission);
      --  a movement from before it does not go out any more

      Ask (Move, Go_Forward, 801, 3, 0);
      Check (Move, Overtaken);
      Ask (Move, Go_Forward, 803, 4, 0);
      Check (Move);
   end Test_Mission_In_Turn;

   procedure Test_Rights is

      procedure Check_Rights (Over, Hand : Boolean) is
         --  Of the mission of order 901.
         Is_Over, By_Hand : Boolean;
      begin
         Robot.Line.Get_Rights (901, Is_Over, By_Hand);
         Assert (Is_Over = Over, "over: " & Is_Over'Image);
         Assert (By_Hand = Hand, "by hand: " & By_Hand'Image);
      end Check_Rights;

   begin
      Robot.Line.Begin_Session (900);
      Robot.Line.Note_Hand (900);
      Check_Rights (False, False);
      Robot.Line.Note_Hand (902);
      Check_Rights (False, True);
      Robot.Line.Begin_Session (903);
      Check_Rights (True, False);
   end Test_Rights;

   procedure Test_Of_A_Run is
      Run  : Robot.Line_Status.Status;
      Same : Boolean;

      procedure Begin_Run is
      begin
         Ask (Start_Watchdog, Robot.Session.Start_Watchdog);
         Check (Start_Watchdog, Mode => Robot.Session.Started_With_Watchdog);
      end Begin_Run;

      procedure Reload_In (Expected : Boolean) is
      begin
         Robot.Line.Put_In_Run
           (Reload, (Kind => Robot.Session.Reload, others => <>), Run, Same);
         Assert (Same = Expected, "the same run: " & Same'Image);
      end Reload_In;

   begin
      Robot.Line.Begin_Session (500);
      Begin_Run;
      Robot.Line.Get_Status (Run);
      Reload_In (True);
      Check (Reload, Mode => Robot.Session.Started_With_Watchdog);
      Begin_Run;
      Reload_In (False);
      Ask (Query, Ping_Robot, 500, 1, 0);
      Check (Query);
      --  which has ended the second run
      Robot.Line.Get_Status (Run);
      Reload_In (False);
      Ask (Query, Ping_Robot, 501, 2, 0);
      Check (Query);
   end Test_Of_A_Run;

   procedure Test_Out_Of_Date is
   begin
      Robot.Line.Begin_Session (300);
      Ask (Reset, Reset_Robot, 301, 7, 5);
      Stop (302);
      Robot.Line.Begin_Session (310);
      Check (Reset, Out_Of_Date);

      --  and does not count among the orders of the new one

      Ask (Open, Open_Robot, 310, 1, 0);
      Check (Open);
   end Test_Out_Of_Date;

   procedure Test_Overtaken is
   begin
      Robot.Line.Begin_Session (200);
      Ask (Move, Go_Forward, 200, 1, 0);
      Stop (201);
      Check (Stop_Order);
      Check (Move, Overtaken);
      Ask (Move, Go_Forward, 202, 2, 0);
      Check (Move);
   end Test_Overtaken;

   procedure Test_Places is
   begin
      Robot.Line.Begin_Session (100);
      Ask (Move, Go_Forward, 103, 4, 3);
      Ask (Reset, Reset_Robot, 102, 3, 1);
      Ask (Query, Ping_Robot, 101, 2, 1);
      Ask (Open, Open_Robot, 100, 1, 0);
      Stop (104, 3);
      Check (Stop_Order);
      Check (Open);
      Check (Query);
      Check (Reset);
      Check (Move, Overtaken);
   end Test_Places;

   procedure Test_Urgency is
   begin
      Robot.Line.Begin_Session (10);
      Ask (Keep_Alive, Robot.Session.Keep_Alive);
      Ask (Query, Ping_Robot, 11, 2, 0);
      Ask (Battery, Robot.Session.Get_Battery);
      Ask_For_Mission (Robot.Session.Drive, 10);
      Ask (Move, Go_Forward, 13, 3, 0);
      Ask (Reload, Robot.Session.Reload);
      Stop (12);
      Ask (Safe_State, Robot.Session.Close_Line);
      Check (Safe_State);
      Check (Stop_Order);
      Check (Reload);
      Check (Move);
      Check (Mission);
      Check (Battery);
      Check (Query);
      Check (Keep_Alive);
   end Test_Urgency;

   procedure Add_Tests is
   begin
      Run_Test ("the most urgent first", Test_Urgency'Access);
      Run_Test ("a movement older than a stop is void", Test_Overtaken'Access);
      Run_Test ("orders that change the session keep their place",
                Test_Places'Access);
      Run_Test ("orders of a session that has ended", Test_Out_Of_Date'Access);
      Run_Test ("stops without end do not starve the reload",
                Test_Many_Stops'Access);
      Run_Test ("no reload of a run that has ended", Test_Of_A_Run'Access);
      Run_Test ("an order by hand voids those of older missions",
                Test_Hand'Access);
      Run_Test ("a mission's order that waited too long is not sent",
                Test_Late'Access);
      Run_Test ("a mission's order waits for the orders before it",
                Test_Mission_In_Turn'Access);
      Run_Test ("what ends a mission: another session, a hand",
                Test_Rights'Access);
   end Add_Tests;

end Robot_Line_Tests;
