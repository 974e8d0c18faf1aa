--  SPDX-License-Identifier: GPL-3.0-or-later
--  Tests as scripts.

with Ada.Exceptions;        use Ada.Exceptions;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Emulators;
with Expectations;          use Expectations;
with Instants;              use Instants;
with Interfaces.C;          use Interfaces.C;
with Monitor_Clients;       use Monitor_Clients;
with Scenarios;

package body Dialogues is

   function Before_Blank (Text : String) return String is
     (Text (Text'First .. Index (Text & " ", " ") - 1));

   function Behind_Blank (Text : String) return String is
     (if Index (Text, " ") = 0 then ""
      else Text (Index (Text, " ") + 1 .. Text'Last));

   Stop_Limit : constant Duration := 0.5;
   --  F6: the stop is on the wire 100 ms after detection, and an orderly or
   --  abortive close is detected in 50 ms

   End_Limit : constant Duration := 3.0;
   --  F6: 1 s; an orderly stop takes less, too

   type Progress is record
      Round : Natural := 0;
      --  Lines of the log at its beginning
      Since : Instant := Never;
      Mark  : Natural := 0;
      --  The last signal or leaving, and the lines of the log then
   end record;

   procedure Play_Step (R : in out Rig; Step : String; P : in out Progress) is
      Verb : constant String := Before_Blank (Step);
      Rest : constant String := Behind_Blank (Step);
      Word : constant String := Before_Blank (Rest);
      More : constant String := Behind_Blank (Rest);
   begin
      if Verb in "signal" | "close" | "reset" | "half-close" then
         P.Mark := R.Supervisor.Log_Length;
         P.Since := Now;
      end if;
      if Verb = "send" then
         R.Monitor.Send_Line (Rest);
      elsif Verb = "answer" then
         declare
            Label : constant String := R.Monitor.Next_Answer.Label;
         begin
            Check (Index (Rest, Label) > 0, Label);
         end;
      elsif Verb = "comes" then
         declare
            Item : constant Message :=
              R.Monitor.Next_Of (Rest (Rest'First .. Rest'First + 3));
         begin
            Check (Index (Item.Label & ":" & Item.Data, Rest) = 1,
                   To_String (Item.Data));
         end;
      elsif Verb = "silence" then
         R.Monitor.Expect_Silence (More, Duration'Value (Word));
      elsif Verb = "tell" then
         R.Emulator.Tell (Rest);
      elsif Step = "status missed_total 0" then
         Check_In_Time
           (R.Emulator.Status ("missed_total") = "0", "windows missed");
      elsif Verb = "status" then
         R.Emulator.Await_Status (Word, More);
      elsif Verb = "clear" then
         R.Emulator.Clear_Journal;
      elsif Verb = "wire" then
         Check (R.Emulator.Wire_Text = (if Rest = "" then "" else Rest & " "),
                R.Emulator.Wire_Text);
      elsif Verb = "sent" then
         Check (R.Emulator.Count_Of (Word) = Natural'Value (More),
                R.Emulator.Count_Of (Word)'Image);
      elsif Verb = "seen" then
         declare
            Unused : constant Emulators.Note :=
              R.Emulator.Await_On_Wire (Rest);
         begin
            null;
         end;
      elsif Verb = "unused" then
         Check (R.Emulator.Journal.Is_Empty, R.Emulator.Wire_Text);
      elsif Verb = "log" then
         R.Supervisor.Expect_Log (Rest, After => P.Round);
      elsif Verb = "unsaid" then
         Check (not R.Supervisor.Says (Rest), R.Supervisor.Log_Text);
      elsif Verb = "wait" then
         delay Duration'Value (Rest);
      elsif Verb = "part" then
         R.Monitor.Send (Rest);
      elsif Verb = "close" then
         R.Monitor.Close;
         P.Since := R.Monitor.Left_At;
      elsif Verb = "reset" then
         R.Monitor.Reset;
         P.Since := R.Monitor.Left_At;
      elsif Verb = "half-close" then
         R.Monitor.Half_Close;
      elsif Verb = "connect" then
         Connect (R);
      elsif Verb = "initial" then
         Expect_Initial_State (R);
      elsif Verb = "pause" then
         R.Monitor.Pause;
      elsif Verb = "signal" then
         if R.Supervisor.Is_Running then
            R.Supervisor.Send_Signal (int'Value (Rest));
         end if;
      elsif Verb = "stops" then
         Check_Within (R.Emulator.Await_On_Wire ("M=0").First - P.Since,
                       Stop_Limit, "the stop");
      elsif Verb = "over" then
         R.Supervisor.Expect_Log ("session closed", P.Mark);
         Check_Within
           (R.Supervisor.Time_Of ("session closed", P.Mark) - P.Since,
            End_Limit, "closing the session");
      elsif Verb = "closed" then
         Check (R.Monitor.Closed_By_Peer /= Open, "it is still connected");
      elsif Verb = "ends" then
         Check (R.Supervisor.Exit_Status = Integer'Value (Rest), "status");
         Check_Within (Now - P.Since, End_Limit, "the end");
      else
         R.Monitor.Expect (Verb, Rest);
      end if;
   end Play_Step;

   procedure Play (R : in out Rig; Steps : String; Times : Positive := 1) is
      P     : Progress;
      First : Positive;
      Last  : Natural;
   begin
      for Count in 1 .. Times loop
         P.Round := R.Supervisor.Log_Length;
         First := Steps'First;
         while First <= Steps'Last loop
            Last := Index (Steps & ", ", ", ", First) - 1;
            begin
               Play_Step (R, Steps (First .. Last), P);
            exception
               when Occurrence : Failed | Too_Late =>
                  Raise_Exception
                    (Exception_Identity (Occurrence),
                     Steps (First .. Last) & ", round" & Count'Image & ": "
                     & Exception_Message (Occurrence));
            end;
            First := Last + 3;
         end loop;
      end loop;
   end Play;

   procedure Script
     (Name               : String;
      Steps              : String;
      Emulator_Options   : String   := "";
      Supervisor_Options : String   := "";
      Camera             : Boolean  := False;
      Terminal           : Boolean  := False;
      Times              : Positive := 1;
      Timed, In_Time     : Boolean  := False)
   is

      procedure Run is
         R : Rig;
      begin
         Assemble (R, Camera, Emulator_Options, Supervisor_Options,
                   Terminal => Terminal);
         Play (R, Steps, Times);
      end Run;

   begin
      Scenarios.Add (Name, Run'Access, Timed, In_Time);
   end Script;

end Dialogues;
