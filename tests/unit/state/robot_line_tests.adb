--  SPDX-License-Identifier: GPL-3.0-or-later
--  Who gets the robot's line: urgency, void movements, places kept, missions.

with Ada.Real_Time;    use Ada.Real_Time;
with Commands;         use Commands;
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

   procedure Check_Rights (Script, Number, Expected : String) is
      --  Of the mission of that order
      Is_Over, By_Hand : Boolean;
   begin
      Robot.Line.Grant.Get_Rights (Ticket'Value (Number), Is_Over, By_Hand);
      Assert ((if Is_Over then "over" else "")
              & (if By_Hand then "hand" else "") = Expected,
              Script & ": " & Is_Over'Image & By_Hand'Image);
   end Check_Rights;

   procedure Check_Due (Script, From : String; Least : Time) is
      Next : Time;
   begin
      Robot.Line.Look (Source'Value (From), Next);
      Assert (Next >= Least, Script & ": " & From);
   end Check_Due;

   procedure Play (Script : String) is
      --  Its words: "session:N" begins one, whose first order is N, with a
      --  robot that is not started, "begin:N" only that; "run:N" is a start
      --  with watchdog by order N, "run:N:AGE" one that was sent so many
      --  milliseconds ago; "COMMAND:N" is the monitor's order N, and
      --  "mission:REQUEST:N" what the mission that it began asks for; "safe"
      --  asks for the end of the session. ">SOURCE" is the next job, which is
      --  done, ">SOURCE:VERDICT" where it is not carried out; with "stopped"
      --  the robot has left its run after it. "wait:N" milliseconds;
      --  "due:SOURCE:N" not before as many, "never:SOURCE" at no time.
      --  "rights:N:WHY": why the mission of order N has to end

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

         function Span return Time_Span is
           (Milliseconds (Integer'Value (Last)));

      begin
         if Kind = "begin" then
            Robot.Line.Grant.Begin_Session (Ticket'Value (Last));
         elsif Kind = "session" then
            Mode := Robot.Session.Not_Started;
            Robot.Line.Grant.Begin_Session (Ticket'Value (Last));
            Ask_For_Safe_State;
            Check (Script, Safe_State);
         elsif Kind = "safe" then
            Ask_For_Safe_State;
         elsif Kind = "stopped" then
            Mode := Robot.Session.Not_Started;
         elsif Kind = "wait" then
            delay until Clock + Span;
         elsif Kind = "due" then
            Check_Due (Script, Word (2), Clock + Span);
         elsif Kind = "never" then
            Check_Due (Script, Last, Time_Last);
         elsif Kind = "rights" then
            Check_Rights (Script, Word (2), Last);
         elsif Kind = "run" then
            Put (Start_Robot_Watchdog, Ticket'Value (Word (2)));
            Mode := Robot.Session.Started_With_Watchdog;
            Check (Script, Other_Order,
                   Since => (if Word.Last_Index = 2 then Time_Span_Zero
                             else Span));
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

   procedure Test_Times is
   begin
      Assert (Schedule.Reload_Period = Milliseconds (1_000)
              and then Schedule.Reload_Quiet = Milliseconds (20)
              and then Schedule.Battery_Offset = Milliseconds (250)
              and then Schedule.Mission_Order_Limit = Milliseconds (50),
              "other times than in the scripts");
   end Test_Times;

   Never : constant String := "never:Reload never:Battery ";

begin
   Run_Test ("one task at a time has the line", Test_One_At_A_Time'Access);
   Run_Test ("the times below", Test_Times'Access);
   Run_Scripts
     (Play'Access,
      "the most urgent first: session:10 run:10:1000 Stop_Robot:11 "
      & "Go_Forward:12 mission:Drive:13 Ping_Robot:14 safe >Safe_State "
      & ">Stop_Order >Reload >Movement:Overtaken >Mission >Battery "
      & ">Other_Order"

      & "|a movement older than a stop is void: session:200 Go_Forward:200 "
      & "Stop_Robot:201 >Stop_Order >Movement:Overtaken Go_Forward:202 "
      & ">Movement"

      --  a movement goes before a question, but a reset not before it
      & "|orders that change the session keep their place: session:100 "
      & "Open_Robot:100 Ping_Robot:101 Reset_Robot:102 Go_Forward:103 "
      & "Stop_Robot:104 >Stop_Order >Other_Order >Other_Order >Other_Order "
      & ">Movement:Overtaken Ping_Robot:105 Go_Forward:106 Reset_Robot:107 "
      & ">Movement >Other_Order >Other_Order"

      --  The end of the session has removed the first two; the third comes
      --  after it
      & "|orders of a session that has ended: session:300 Reset_Robot:301 "
      & "Stop_Robot:302 session:310 Reset_Robot:303 >Other_Order:Out_Of_Date "
      & "Open_Robot:310 >Other_Order"

      --  Nothing but a reload goes before a stop
      & "|stops without end do not starve the reload: session:400 "
      & "run:400:1000 Go_Forward:399 Stop_Robot:401 Stop_Robot:402 "
      & "Stop_Robot:403 >Stop_Order >Reload >Stop_Order >Stop_Order "
      & ">Movement:Out_Of_Date"

      & "|nothing is due for a run that has ended: session:500 " & Never
      & "run:500:999 Reset_Robot:501 wait:2 >Reload >Battery stopped "
      & ">Other_Order " & Never & "run:502 due:Reload:899 due:Battery:149"

      & "|the line is kept free for the reload: session:550 run:550:980 "
      & "Ping_Robot:551 Go_Forward:552 >Movement wait:20 >Reload >Battery "
      & ">Other_Order"

      --  nor is what it asks for later, a stop included
      & "|an order by hand voids those of older missions: session:600 "
      & "mission:Drive:600 Stop_Robot:601 >Stop_Order >Mission:Overtaken "
      & "mission:Get_Moving:600 >Mission:Overtaken mission:Stop:600 "
      & ">Mission:Overtaken mission:Drive:602 >Mission mission:Stop:602 "
      & "begin:603 >Mission:Out_Of_Date"

      & "|a mission's order that waited too long is not sent: session:700 "
      & "mission:Drive:700 wait:55 >Mission:Late mission:Stop:700 wait:55 "
      & ">Mission"

      --  A movement from before it does not go out any more
      & "|a mission's order waits for the orders before it: session:800 "
      & "Open_Robot:800 Reset_Robot:801 mission:Stop:802 >Other_Order "
      & ">Other_Order >Mission Go_Forward:801 >Movement:Overtaken "
      & "Go_Forward:803 >Movement"

      & "|what ends a mission, another session, a hand: session:900 "
      & "Go_Forward:900 >Movement rights:901: Ping_Robot:902 >Other_Order "
      & "rights:901: Go_Forward:903 >Movement rights:901:hand session:904 "
      & "rights:901:over");
end Robot_Line_Tests;
