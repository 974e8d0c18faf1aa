--  SPDX-License-Identifier: GPL-3.0-or-later
--  Who gets the robot's line: urgency, void movements, places kept, missions.

with AUnit.Assertions; use AUnit.Assertions;

with Ada.Real_Time;    use Ada.Real_Time;
with Commands;         use Commands;
with Robot.Line;
with Robot.Line_Status;
with Robot.Requests;   use Robot.Requests;
with Robot.Session;
with Schedule;
with Unit_Runs; use Unit_Runs;

package body Robot_Line_Tests is

   procedure Put (Name : Robot_Command; Number : Ticket) is
      --  The monitor's order
      Order : Commands.Order :=
        (Number, (Name, 0), Owed => True, others => <>);
   begin
      Robot.Line.Put (Order);
   end Put;

   procedure Ask_For_Mission
     (Kind : Commands.Request_Kind; Number : Ticket) is
      --  What the mission asks for that the monitor's order Number began
   begin
      Robot.Line.Ask (Mission, (Kind => Kind, others => <>),
                      (Number => Number, others => <>));
   end Ask_For_Mission;

   procedure Take
     (Item : in out Job; Verdict : out Verdict_Kind; Found : out Boolean)
   is
      --  By the task whose turn it is
      Ignored : Robot.Line_Status.Dialogue;
   begin
      for Who in Schedule.Task_Name loop
         Robot.Line.Take (Who, Item, Verdict, Ignored, Found);
         exit when Found;
      end loop;
   end Take;

   procedure Finish
     (Item : Job;
      Mode : Robot.Session.Mode_Kind := Robot.Session.Not_Started;
      Age  : Time_Span := Time_Span_Zero) is
   begin
      Robot.Line.Finish
        (Item,
         (State   => (Line_Open => True, Mode => Mode, others => <>),
          Counted => Clock - Age,
          others  => <>),
         (others => <>));
   end Finish;

   procedure Check
     (From    : Source;
      Verdict : Verdict_Kind := Carry_Out;
      Mode    : Robot.Session.Mode_Kind := Robot.Session.Not_Started;
      Age     : Time_Span := Time_Span_Zero)
   is
      --  The next job is From's, and is done; then the robot is in Mode. Age:
      --  of the start or reload
      Item   : Job;
      Actual : Verdict_Kind;
      Found  : Boolean;
   begin
      Take (Item, Actual, Found);
      Assert (Found, "nobody has the line for " & From'Image);
      Assert (Item.From = From,
              From'Image & " expected, not " & Item.From'Image);
      Assert (Actual = Verdict, From'Image & Actual'Image);
      Assert (not (Item.Order.Owed and then From = Mission),
              "a mission's order is answered when it begins, not here");
      Finish (Item, Mode, Age);
   end Check;

   procedure Begin_Session (First : Ticket) is
      --  With a robot that is not started
   begin
      Robot.Line.Begin_Session (First);
      Robot.Line.Ask
        (Safe_State, (Kind => Commands.Close_Line, others => <>),
         (others => <>));
      Check (Safe_State);
   end Begin_Session;

   Running : constant Robot.Session.Mode_Kind :=
     Robot.Session.Started_With_Watchdog;

   procedure Begin_Run (Number : Ticket; Age : Time_Span := Time_Span_Zero) is
      --  A start with watchdog, sent so long ago
   begin
      Put (Start_Robot_Watchdog, Number);
      Check (Other_Order, Mode => Running, Age => Age);
   end Begin_Run;

   procedure Test_Many_Stops is
   begin
      Begin_Session (400);
      Begin_Run (400, Schedule.Reload_Period);
      Put (Go_Forward, 399);
      for Number in Ticket range 401 .. 403 loop
         Put (Stop_Robot, Number);
      end loop;
      Check (Stop_Order, Mode => Running);
      Check (Reload, Mode => Running);
      Check (Stop_Order, Mode => Running);
      --  nothing else goes before a stop
      Check (Stop_Order, Mode => Running);
      Check (Robot.Requests.Movement, Out_Of_Date, Mode => Running);
   end Test_Many_Stops;

   procedure Test_One_At_A_Time is
      Item, Other : Job;
      Verdict     : Verdict_Kind;
      Found       : Boolean;
   begin
      Begin_Session (600);
      Put (Ping_Robot, 600);
      Take (Item, Verdict, Found);
      Assert (Found, "nobody has the line");
      Put (Stop_Robot, 601);
      Take (Other, Verdict, Found);
      Assert (not Found, "two have the line");
      Finish (Item);
      Check (Stop_Order);
      Take (Other, Verdict, Found);
      Assert (not Found, "somebody has the line for nothing");
   end Test_One_At_A_Time;

   procedure Test_Hand is
   begin
      Begin_Session (600);
      Ask_For_Mission (Commands.Drive, 600);
      Put (Stop_Robot, 601);
      Check (Stop_Order);
      Check (Mission, Overtaken);
      --  nor is what it asks for later, a stop included

      Ask_For_Mission (Commands.Get_Moving, 600);
      Check (Mission, Overtaken);
      Ask_For_Mission (Commands.Stop, 600);
      Check (Mission, Overtaken);

      Ask_For_Mission (Commands.Drive, 602);
      Check (Mission);

      Ask_For_Mission (Commands.Stop, 602);
      Robot.Line.Begin_Session (603);
      Check (Mission, Out_Of_Date);
   end Test_Hand;

   procedure Test_Late is

      procedure Pass_Limit is
      begin
         delay until Clock + Schedule.Mission_Order_Limit + Milliseconds (5);
      end Pass_Limit;

   begin
      Begin_Session (700);
      Ask_For_Mission (Commands.Drive, 700);
      Pass_Limit;
      Check (Mission, Late);
      Ask_For_Mission (Commands.Stop, 700);
      Pass_Limit;
      Check (Mission);
   end Test_Late;

   procedure Test_Mission_In_Turn is
   begin
      Begin_Session (800);
      Put (Open_Robot, 800);
      Put (Reset_Robot, 801);
      Ask_For_Mission (Commands.Stop, 802);
      Check (Other_Order);
      Check (Other_Order);
      Check (Mission);
      --  a movement from before it does not go out any more

      Put (Go_Forward, 801);
      Check (Robot.Requests.Movement, Overtaken);
      Put (Go_Forward, 803);
      Check (Robot.Requests.Movement);
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
      Begin_Session (900);
      Put (Go_Forward, 900);
      Check (Robot.Requests.Movement);
      Check_Rights (False, False);
      Put (Ping_Robot, 902);
      Check (Other_Order);
      Check_Rights (False, False);
      Put (Go_Forward, 903);
      Check (Robot.Requests.Movement);
      Check_Rights (False, True);
      Begin_Session (904);
      Check_Rights (True, False);
   end Test_Rights;

   procedure Test_Of_A_Run is

      procedure Check_Due (From : Periodic; After : Time_Span) is
         --  Not before that time has passed
         Next : Time;
         Now  : constant Time := Clock;
      begin
         Robot.Line.Look (From, Next);
         Assert (Next > Now + After - Milliseconds (1), From'Image & " early");
      end Check_Due;

      procedure Check_Never (From : Periodic) is
         Next : Time;
      begin
         Robot.Line.Look (From, Next);
         Assert (Next = Time_Last, From'Image & " for nothing");
      end Check_Never;

   begin
      Begin_Session (500);
      Check_Never (Reload);
      Check_Never (Battery);
      Begin_Run (500, Schedule.Reload_Period - Milliseconds (1));
      Put (Reset_Robot, 501);
      delay until Clock + Milliseconds (2);
      Check (Reload, Mode => Running);
      Check (Battery, Mode => Running);
      Check (Other_Order);
      Check_Never (Reload);
      Check_Never (Battery);
      Begin_Run (502);
      Check_Due (Reload, Schedule.Reload_Period - Milliseconds (100));
      Check_Due (Battery, Schedule.Battery_Offset - Milliseconds (100));
   end Test_Of_A_Run;

   procedure Test_Quiet is
   begin
      Begin_Session (550);
      Begin_Run (550, Schedule.Reload_Period - Schedule.Reload_Quiet);
      Put (Ping_Robot, 551);
      Put (Go_Forward, 552);
      Check (Robot.Requests.Movement, Mode => Running);
      delay until Clock + Schedule.Reload_Quiet;
      Check (Reload, Mode => Running);
      Check (Battery, Mode => Running);
      Check (Other_Order, Mode => Running);
   end Test_Quiet;

   procedure Test_Out_Of_Date is
   begin
      Begin_Session (300);
      Put (Reset_Robot, 301);
      Put (Stop_Robot, 302);
      Begin_Session (310);
      --  the end of the session has removed them; one that comes after it

      Put (Reset_Robot, 303);
      Check (Other_Order, Out_Of_Date);
      Put (Open_Robot, 310);
      Check (Other_Order);
   end Test_Out_Of_Date;

   procedure Test_Overtaken is
   begin
      Begin_Session (200);
      Put (Go_Forward, 200);
      Put (Stop_Robot, 201);
      Check (Stop_Order);
      Check (Robot.Requests.Movement, Overtaken);
      Put (Go_Forward, 202);
      Check (Robot.Requests.Movement);
   end Test_Overtaken;

   procedure Test_Places is
   begin
      Begin_Session (100);
      Put (Open_Robot, 100);
      Put (Ping_Robot, 101);
      Put (Reset_Robot, 102);
      Put (Go_Forward, 103);
      Put (Stop_Robot, 104);
      Check (Stop_Order);
      Check (Other_Order);
      Check (Other_Order);
      Check (Other_Order);
      Check (Robot.Requests.Movement, Overtaken);
      --  a movement goes before a question, but a reset not before it

      Put (Ping_Robot, 105);
      Put (Go_Forward, 106);
      Put (Reset_Robot, 107);
      Check (Robot.Requests.Movement);
      Check (Other_Order);
      Check (Other_Order);
   end Test_Places;

   procedure Test_Urgency is
   begin
      Begin_Session (10);
      Begin_Run (10, Schedule.Reload_Period);
      Put (Stop_Robot, 11);
      Put (Go_Forward, 12);
      Ask_For_Mission (Commands.Drive, 13);
      Put (Ping_Robot, 14);
      Robot.Line.Ask
        (Safe_State, (Kind => Commands.Close_Line, others => <>),
         (others => <>));
      Check (Safe_State, Mode => Running);
      Check (Stop_Order, Mode => Running);
      Check (Reload, Mode => Running);
      Check (Robot.Requests.Movement, Overtaken, Mode => Running);
      Check (Mission, Mode => Running);
      Check (Battery, Mode => Running);
      Check (Other_Order, Mode => Running);
   end Test_Urgency;

   procedure Add_Tests is
   begin
      Run_Test ("the most urgent first", Test_Urgency'Access);
      Run_Test ("one task at a time has the line", Test_One_At_A_Time'Access);
      Run_Test ("a movement older than a stop is void", Test_Overtaken'Access);
      Run_Test ("orders that change the session keep their place",
                Test_Places'Access);
      Run_Test ("orders of a session that has ended", Test_Out_Of_Date'Access);
      Run_Test ("stops without end do not starve the reload",
                Test_Many_Stops'Access);
      Run_Test ("nothing is due for a run that has ended",
                Test_Of_A_Run'Access);
      Run_Test ("the line is kept free for the reload", Test_Quiet'Access);
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
