--  SPDX-License-Identifier: GPL-3.0-or-later
--  Who gets the robot's line: urgency, void movements, places kept, missions.

with Ada.Real_Time;    use Ada.Real_Time;
with Commands;         use Commands;
with Plain_Numbers;
with Robot.Line;
with Robot.Line_Status;
with Robot.Requests;   use Robot.Requests;
with Robot.Session;
with Schedule;
with Unit_Runs; use Unit_Runs;

procedure Robot_Line_Tests is

   Mode : Robot.Session.Mode_Kind;
   --  That the robot is in after the next job

   procedure Take
     (Item : in out Job; Verdict : out Verdict_Kind; Found : out Boolean)
   is
      --  By the task whose turn it is
      Ignored : Robot.Line_Status.Dialogue;
   begin
      for Who in Schedule.Task_Name loop
         Robot.Line.Grant.Take (Who, Item, Verdict, Ignored, Found);
         exit when Found;
      end loop;
   end Take;

   procedure Finish (Item : Job; Since : Time_Span := Time_Span_Zero) is
      --  Since: its start or reload
   begin
      Robot.Line.Finish
        (Item,
         (State   => (Line_Open => True, Mode => Mode, others => <>),
          Counted => Clock - Since,
          others  => <>),
         (others => <>));
   end Finish;

   procedure Check
     (Script  : String;
      From    : Source;
      Verdict : Verdict_Kind := Carry_Out;
      Since   : Time_Span := Time_Span_Zero)
   is
      --  The next job is From's, and is done
      Item   : Job;
      Actual : Verdict_Kind;
      Found  : Boolean;
   begin
      Take (Item, Actual, Found);
      Assert (Found, Script & ": nobody has the line for " & From'Image);
      Assert (Item.From = From,
              Script & ": " & From'Image & ", not " & Item.From'Image);
      Assert (Actual = Verdict,
              Script & ": " & From'Image & " " & Actual'Image);
      Assert (not (Item.Order.Owed and then From = Mission),
              "a mission's order is answered when it begins, not here");
      Finish (Item, Since);
   end Check;

   procedure Play (Script : String) is
      --  Its words: "session:N" begins one, whose first order is N, with a
      --  robot that is not started; "run:N" is a start with watchdog by order
      --  N, "run:N:AGE" one that was sent so many milliseconds ago;
      --  "COMMAND:N" is the monitor's order N, and "mission:REQUEST:N" what
      --  the mission that it began asks for; "safe" asks for the end of the
      --  session. ">SOURCE" is the next job, which is done, ">SOURCE:VERDICT"
      --  where it is not carried out

      procedure Ask_For_Safe_State is
      begin
         Robot.Line.Ask
           (Safe_State, (Kind => Commands.Close_Line, others => <>),
            (others => <>));
      end Ask_For_Safe_State;

      procedure Put (Name : Robot_Command; Number : Ticket) is
         Order : Commands.Order :=
           (Number, (Name, 0), Owed => True, others => <>);
      begin
         Robot.Line.Put (Order);
      end Put;

      procedure Carry_Out (Word : Line_Vectors.Vector) is
         Kind : constant String := Word (1);
         Last : constant String := Word (Word.Last_Index);
      begin
         if Kind = "session" then
            Mode := Robot.Session.Not_Started;
            Robot.Line.Grant.Begin_Session (Ticket'Value (Last));
            Ask_For_Safe_State;
            Check (Script, Safe_State);
         elsif Kind = "safe" then
            Ask_For_Safe_State;
         elsif Kind = "run" then
            Put (Start_Robot_Watchdog, Ticket'Value (Word (2)));
            Mode := Robot.Session.Started_With_Watchdog;
            Check (Script, Other_Order,
                   Since => (if Word.Last_Index = 2 then Time_Span_Zero
                             else Milliseconds (Integer'Value (Last))));
         elsif Kind = "mission" then
            Robot.Line.Ask
              (Mission,
               (Kind   => Commands.Request_Kind'Value (Word (2)),
                others => <>),
               (Number => Ticket'Value (Last), others => <>));
         elsif Kind (Kind'First) = '>' then
            Check (Script, Source'Value (Kind (Kind'First + 1 .. Kind'Last)),
                   (if Word.Last_Index = 1 then Carry_Out
                    else Verdict_Kind'Value (Last)));
         else
            Put (Robot_Command'Value (Kind), Ticket'Value (Last));
         end if;
      end Carry_Out;

   begin
      for Word of Split (Script, ' ') loop
         Carry_Out (Split (Word, ':'));
      end loop;
   end Play;

   procedure Test_Many_Stops is
   begin
      --  Nothing but a reload goes before a stop
      Play ("session:400 run:400:1000 Go_Forward:399 Stop_Robot:401 "
            & "Stop_Robot:402 Stop_Robot:403 >Stop_Order >Reload >Stop_Order "
            & ">Stop_Order >Movement:Out_Of_Date");
   end Test_Many_Stops;

   procedure Test_One_At_A_Time is
      Item, Other : Job;
      Verdict     : Verdict_Kind;
      Found       : Boolean;
   begin
      Play ("session:600 Ping_Robot:600");
      Take (Item, Verdict, Found);
      Assert (Found, "nobody has the line");
      Play ("Stop_Robot:601");
      Take (Other, Verdict, Found);
      Assert (not Found, "two have the line");
      Finish (Item);
      Play (">Stop_Order");
      Take (Other, Verdict, Found);
      Assert (not Found, "somebody has the line for nothing");
   end Test_One_At_A_Time;

   procedure Test_Hand is
   begin
      Play ("session:600 mission:Drive:600 Stop_Robot:601 >Stop_Order "
            & ">Mission:Overtaken");
      --  nor is what it asks for later, a stop included

      Play ("mission:Get_Moving:600 >Mission:Overtaken mission:Stop:600 "
            & ">Mission:Overtaken mission:Drive:602 >Mission "
            & "mission:Stop:602");
      Robot.Line.Grant.Begin_Session (603);
      Play (">Mission:Out_Of_Date");
   end Test_Hand;

   procedure Test_Late is

      procedure Pass_Limit is
      begin
         delay until Clock + Schedule.Mission_Order_Limit + Milliseconds (5);
      end Pass_Limit;

   begin
      Play ("session:700 mission:Drive:700");
      Pass_Limit;
      Play (">Mission:Late mission:Stop:700");
      Pass_Limit;
      Play (">Mission");
   end Test_Late;

   procedure Test_Mission_In_Turn is
   begin
      --  A movement from before it does not go out any more
      Play ("session:800 Open_Robot:800 Reset_Robot:801 mission:Stop:802 "
            & ">Other_Order >Other_Order >Mission Go_Forward:801 "
            & ">Movement:Overtaken Go_Forward:803 >Movement");
   end Test_Mission_In_Turn;

   procedure Test_Rights is

      procedure Check_Rights (Over, Hand : Boolean) is
         --  Of the mission of order 901.
         Is_Over, By_Hand : Boolean;
      begin
         Robot.Line.Grant.Get_Rights (901, Is_Over, By_Hand);
         Assert (Is_Over = Over, "over: " & Is_Over'Image);
         Assert (By_Hand = Hand, "by hand: " & By_Hand'Image);
      end Check_Rights;

   begin
      Play ("session:900 Go_Forward:900 >Movement");
      Check_Rights (False, False);
      Play ("Ping_Robot:902 >Other_Order");
      Check_Rights (False, False);
      Play ("Go_Forward:903 >Movement");
      Check_Rights (False, True);
      Play ("session:904");
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

      procedure Check_Never is
         Next : Time;
      begin
         for From in Source range Reload .. Battery loop
            if From in Periodic then
               Robot.Line.Look (From, Next);
               Assert (Next = Time_Last, From'Image & " for nothing");
            end if;
         end loop;
      end Check_Never;

   begin
      Play ("session:500");
      Check_Never;
      Play ("run:500:999 Reset_Robot:501");
      delay until Clock + Milliseconds (2);
      Play (">Reload >Battery");
      Mode := Robot.Session.Not_Started;
      Play (">Other_Order");
      Check_Never;
      Play ("run:502");
      Check_Due (Reload, Schedule.Reload_Period - Milliseconds (100));
      Check_Due (Battery, Schedule.Battery_Offset - Milliseconds (100));
   end Test_Of_A_Run;

   procedure Test_Quiet is
      Before : constant Natural :=
        (Schedule.Reload_Period - Schedule.Reload_Quiet) / Milliseconds (1);
   begin
      Play ("session:550 run:550:" & Plain_Numbers.Image (Before)
            & " Ping_Robot:551 Go_Forward:552 >Movement");
      delay until Clock + Schedule.Reload_Quiet;
      Play (">Reload >Battery >Other_Order");
   end Test_Quiet;

   procedure Test_Out_Of_Date is
   begin
      --  The end of the session has removed the first two; the third comes
      --  after it
      Play ("session:300 Reset_Robot:301 Stop_Robot:302 session:310 "
            & "Reset_Robot:303 >Other_Order:Out_Of_Date Open_Robot:310 "
            & ">Other_Order");
   end Test_Out_Of_Date;

   procedure Test_Overtaken is
   begin
      Play ("session:200 Go_Forward:200 Stop_Robot:201 >Stop_Order "
            & ">Movement:Overtaken Go_Forward:202 >Movement");
   end Test_Overtaken;

   procedure Test_Places is
   begin
      Play ("session:100 Open_Robot:100 Ping_Robot:101 Reset_Robot:102 "
            & "Go_Forward:103 Stop_Robot:104 >Stop_Order >Other_Order "
            & ">Other_Order >Other_Order >Movement:Overtaken");
      --  a movement goes before a question, but a reset not before it

      Play ("Ping_Robot:105 Go_Forward:106 Reset_Robot:107 >Movement "
            & ">Other_Order >Other_Order");
   end Test_Places;

   procedure Test_Urgency is
   begin
      Play ("session:10 run:10:1000 Stop_Robot:11 Go_Forward:12 "
            & "mission:Drive:13 Ping_Robot:14 safe >Safe_State >Stop_Order "
            & ">Reload >Movement:Overtaken >Mission >Battery >Other_Order");
   end Test_Urgency;

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
end Robot_Line_Tests;
