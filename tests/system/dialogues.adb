--  SPDX-License-Identifier: GPL-3.0-or-later
--  Tests as scripts.

with Ada.Exceptions;        use Ada.Exceptions;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Emulators;
with Expectations;          use Expectations;
with Monitor_Clients;       use Monitor_Clients;
with Scenarios;

package body Dialogues is

   function Before_Blank (Text : String) return String is
     (Text (Text'First .. Index (Text & " ", " ") - 1));

   function Behind_Blank (Text : String) return String is
     (if Index (Text, " ") = 0 then ""
      else Text (Index (Text, " ") + 1 .. Text'Last));

   procedure Play_Step (R : in out Rig; Step : String; Round : Natural) is
      --  Round: the length of the log at its beginning
      Verb : constant String := Before_Blank (Step);
      Rest : constant String := Behind_Blank (Step);
      Word : constant String := Before_Blank (Rest);
      More : constant String := Behind_Blank (Rest);
   begin
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
         R.Supervisor.Expect_Log (Rest, After => Round);
      elsif Verb = "unsaid" then
         Check (not R.Supervisor.Says (Rest), R.Supervisor.Log_Text);
      elsif Verb = "wait" then
         delay Duration'Value (Rest);
      else
         R.Monitor.Expect (Verb, Rest);
      end if;
   end Play_Step;

   procedure Play (R : in out Rig; Steps : String; Times : Positive := 1) is
      Round : Natural;
      First : Positive;
      Last  : Natural;
   begin
      for Count in 1 .. Times loop
         Round := R.Supervisor.Log_Length;
         First := Steps'First;
         while First <= Steps'Last loop
            Last := Index (Steps & ", ", ", ", First) - 1;
            begin
               Play_Step (R, Steps (First .. Last), Round);
            exception
               when Occurrence : Failed =>
                  raise Failed with
                    Steps (First .. Last) & ", round" & Count'Image & ": "
                    & Exception_Message (Occurrence);
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
      Timed              : Boolean  := False)
   is

      procedure Run is
         R : Rig;
      begin
         Assemble
           (R, Camera, Emulator_Options, Supervisor_Options,
            Terminal => Terminal);
         Play (R, Steps, Times);
      end Run;

   begin
      Scenarios.Add (Name, Run'Access, Timed);
   end Script;

end Dialogues;
