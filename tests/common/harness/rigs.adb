--  SPDX-License-Identifier: GPL-3.0-or-later
--  The three parties together.

with Ada.Exceptions;        use Ada.Exceptions;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Maps;      use Ada.Strings.Maps;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Interfaces.C;          use Interfaces.C;

with Child_Processes;       use Child_Processes;
with Expectations;          use Expectations;
with Instants;              use Instants;
with Libc;
with Monitor_Clients;       use Monitor_Clients;

package body Rigs is

   Stop_Limit : constant Duration := 0.5;
   --  F6: the stop is on the wire 100 ms after detection, and an orderly or
   --  abortive close is detected in 50 ms

   End_Limit : constant Duration := 3.0;
   --  F6: 1 s; an orderly stop takes less, too

   procedure Assemble
     (R                  : in out Rig;
      Camera             : Boolean := False;
      Emulator_Options   : String  := "";
      Supervisor_Options : String  := "";
      Launcher           : String  := "";
      Program            : String  := "";
      Bind               : String  := "127.0.0.1";
      Connected          : Boolean := True;
      Terminal           : Boolean := False)
   is
      Unused : Emulators.Note;
   begin
      R.Emulator.Start (Camera, Emulator_Options, Terminal);
      R.Supervisor.Start
        ("--serial " & R.Emulator.Device
         & (if Camera then " --camera " & R.Emulator.Camera_Url else "")
         & " " & Supervisor_Options,
         Launcher, Program, Bind);
      --  each supervisor begins with a stop
      Unused := R.Emulator.Await_On_Wire ("M=0");
      R.Emulator.Clear_Journal;
      if Connected and then Bind = "127.0.0.1" then
         Connect (R);
      end if;
   end Assemble;

   procedure Start
     (R                          : in out Rig;
      Options, Launcher, Program : String := "") is
   begin
      R.Supervisor.Start (Options, Launcher, Program);
      Connect (R);
   end Start;

   procedure Connect (R : in out Rig) is
   begin
      R.Monitor.Connect (R.Supervisor.Port);
   end Connect;

   --  Scripts

   type Progress is record
      Round : Natural := 0;
      --  Lines of the log at its beginning
      Since : Instant := Never;
      Mark  : Natural := 0;
      --  The last signal or leaving, and the lines of the log then
   end record;

   function Before_Blank (Text : String) return String is
     (Text (Text'First .. Index (Text & " ", " ") - 1));

   function Behind_Blank (Text : String) return String is
     (if Index (Text, " ") = 0 then ""
      else Text (Index (Text, " ") + 1 .. Text'Last));

   function Replaced (Text : String; By : String) return String is
     (if Index (Text, "$") = 0 then Text
      else Text (Text'First .. Index (Text, "$") - 1) & By
        & Replaced (Text (Index (Text, "$") + 1 .. Text'Last), By));

   procedure Play_Step (R : in out Rig; Step : String; P : in out Progress) is
      Verb : constant String := Before_Blank (Step);
      Rest : constant String := Behind_Blank (Step);
      Word : constant String := Before_Blank (Rest);
      More : constant String := Behind_Blank (Rest);
      Unused : Emulators.Note;
   begin
      if Verb in "signal" | "close" | "reset" | "half-close" then
         P.Mark := R.Supervisor.Count;
         P.Since := Now;
      end if;
      if Verb = "send" then
         R.Monitor.Send_Line
           (Translate (Rest, To_Mapping ("|", (1 => ASCII.LF))));
      elsif Verb = "answer" then
         for Labels of Words (Rest) loop
            Check_Label (R.Monitor.Next_Of (Answers & " " & Labels),
                         Labels, Rest);
         end loop;
      elsif Verb = "soon" then
         declare
            Start : constant Instant := Now;
         begin
            Check_Within (R.Monitor.Ask (More).Time - Start,
                          Duration'Value (Word), "the answer");
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
         Unused := R.Emulator.Await_On_Wire (Rest);
      elsif Verb = "unused" then
         Check (R.Emulator.Journal.Is_Empty, R.Emulator.Wire_Text);
      elsif Verb = "log" then
         R.Supervisor.Expect_Log (Rest, After => P.Round);
      elsif Verb = "said" then
         R.Supervisor.Expect_Log (Rest);
      elsif Verb = "unsaid" then
         Check (not R.Supervisor.Says (Rest), R.Supervisor.Text);
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
      elsif Verb = "pause" then
         R.Monitor.Pause;
      elsif Verb = "signal" then
         if R.Supervisor.Is_Running then
            R.Supervisor.Send_Signal (int'Value (Rest));
         end if;
      elsif Verb in "freeze" | "thaw" then
         R.Emulator.Send_Signal
           (if Verb = "freeze" then Libc.Sigstop else Libc.Sigcont);
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
         R.Supervisor.Expect_Exit (Integer'Value (Rest));
         Check_Within (Now - P.Since, End_Limit, "the end");
      else
         R.Monitor.Expect (Verb, Rest);
      end if;
   end Play_Step;

   procedure Play
     (R     : in out Rig;
      Steps : String;
      Times : Positive := 1;
      Each  : String   := "")
   is
      P : Progress;

      procedure Play_Round (Steps : String; Round : String) is
         First : Positive := Steps'First;
         Last  : Natural;
      begin
         P.Round := R.Supervisor.Count;
         while First <= Steps'Last loop
            Last := Index (Steps & ", ", ", ", First) - 1;
            begin
               Play_Step (R, Steps (First .. Last), P);
            exception
               when Occurrence : Failed | Too_Late =>
                  Raise_Exception
                    (Exception_Identity (Occurrence),
                     Steps (First .. Last) & ", round " & Round & ": "
                     & Exception_Message (Occurrence));
            end;
            First := Last + 3;
         end loop;
      end Play_Round;

   begin
      for Word of Words (Each) loop
         Play_Round (Replaced (Steps, Word), Word);
      end loop;
      if Each = "" then
         for Count in 1 .. Times loop
            Play_Round (Steps, Count'Image);
         end loop;
      end if;
   end Play;

end Rigs;
