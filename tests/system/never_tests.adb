--  SPDX-License-Identifier: GPL-3.0-or-later
--  What must never happen, for any input.

with Ada.Numerics.Discrete_Random;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Child_Processes;       use Child_Processes;
with Dialogues;             use Dialogues;
with Expectations;          use Expectations;
with Instants;              use Instants;
with Monitor_Clients;       use Monitor_Clients;
with Process_Facts;
with Rigs;                  use Rigs;
with Scenarios;             use Scenarios;

procedure Never_Tests is

   subtype Byte is Character;
   package Random_Characters is new Ada.Numerics.Discrete_Random (Byte);

   procedure Expect_Alive (R : in out Rig) is
      --  A new session works
   begin
      Check (R.Supervisor.Is_Running, "the supervisor has ended");
      Play (R, "RCLS AACK, ROPN AACK, RSOW AACK, RGFW AACK, RSTP AACK,"
            & " RCLS AACK");
   end Expect_Alive;

   procedure Malformed_Commands is
      R : Rig;

      procedure Refuse (Line : String) is
      begin
         R.Monitor.Expect (Line, "ACER");
      end Refuse;

   begin
      Assemble (R);
      Start_Robot (R);
      R.Emulator.Clear_Journal;
      for Line of Words
        (" |R|RGF|rgfw|RGFWX| RGFW|:RGFW|RMOV|RMOV:|RMOV: |RMOV:x|RMOV:12x"
         & "|RMOV:--1|RMOV:1.5|RMOV:1e3|RMOV:0x10|RMOV 10|RTRN|RTRN:|RTRN:-"
         & "|MGTO:1;2;3;4|MGCM:1;2;3;4|RMOV:1" & ASCII.NUL & "2|" & ASCII.NUL
         & "|RG" & ASCII.NUL & "W|" & Character'Val (16#C3#) & "("
         & Character'Val (16#FF#) & Character'Val (16#FE#) & "|RPIN"
         & Character'Val (16#FF#) & "|AACK|CIMG:abcd", Separator => '|')
      loop
         Refuse (Line);
      end loop;
      Refuse ("");
      Refuse ("RTRN:" & (1 .. 300 => 'z'));
      for Name of Words ("MGTO MPTH MGCM MPCM") loop
         Refuse (Name);
         for Data of Words
           (": :1 :1; :1;2; :1;2;3 ;1;2 :x;1 :+1;2 :1,5;2 :12345678;2"
            & " :1;.5 :1;2.1234567 :;;; :1;;2 :" & (1 .. 300 => '9'))
         loop
            Refuse (Name & Data);
         end loop;
      end loop;
      Refuse ("MPCM:0" & (1 .. 64 => ';') & "1");
      Refuse ("MPCM:" & 64 * "1;2;" & "1;2");
      Refuse ((1 .. 2_000 => 'A'));
      Refuse ("RMOV:" & (1 .. 2_000 => 'A'));
      Check (R.Emulator.Wire_Text = "",
             "malformed orders are on the wire: " & R.Emulator.Wire_Text);
      Expect_Alive (R);
   end Malformed_Commands;

   procedure Superfluous_Data is
      --  Data after a command that takes none: carried out or rejected, one
      --  answer in both cases
      R    : Rig;
      Item : Message;
   begin
      Assemble (R, Camera => True);
      for Name of Words
        ("ROPN RSOW RSWW RRST RPIN RLDW RGFW RGBW RGLF RGRI RSTP MABT RPOF"
         & " RGBT RGST RCLS COPN CPCO CPST CCLS")
      loop
         for Data of Words
           (": :1 :-99999999999999999999999 :x;y :%s%n%n :::: :"
            & (1 .. 500 => 'q'))
         loop
            R.Monitor.Skip_To_Now;
            R.Monitor.Send_Line (Name & Data);
            R.Monitor.Send_Line ("nope");
            Item := R.Monitor.Next_Answer (Name);
            loop
               Item := R.Monitor.Next_Answer (Name);
               --  the battery may have come unsolicited before the answer
               exit when Item.Label /= "RBLV";
            end loop;
            Check_Label (Item, "ACER", "after the answer to " & Name & Data);
         end loop;
      end loop;
      R.Emulator.Tell ("reset-robot");
      R.Emulator.Await_Status ("state", "idle");
      Expect_Alive (R);
   end Superfluous_Data;

   procedure Line_Without_End is
      R      : Rig;
      Piece  : constant String (1 .. 64 * 1024) := (others => 'x');
      Before : Natural;
   begin
      Assemble (R);
      R.Monitor.Expect ("RPIN", "ANAK");
      Before := Process_Facts.Resident_Kilobytes (R.Supervisor.Pid);
      for Number in 1 .. 32 loop
         R.Monitor.Send (Piece);
      end loop;
      R.Monitor.Skip_To_Now;
      R.Monitor.Send ((1 => ASCII.LF));
      Check (R.Monitor.Next_Answer.Label = "ACER",
             "a line of 2 MB is no error");
      R.Monitor.Expect_Silence ("ACER AACK ANAK", For_Time => 0.3);
      Check (Process_Facts.Resident_Kilobytes (R.Supervisor.Pid)
             <= Before + 1024,
             "the line is kept in memory");
      Expect_Alive (R);
   end Line_Without_End;

   procedure Random_Bytes is
      use Random_Characters;
      R      : Rig;
      Source : Generator;
      Text   : String (1 .. 1_000);
      Mark   : Natural;
   begin
      Reset (Source, 5544);
      Assemble (R, Emulator_Options => "--baud 0");
      for Round in 1 .. 200 loop
         if Round mod 20 = 1 then
            R.Monitor.Expect ("RPIN", "ANAK");
         end if;
         for Place of Text loop
            Place := Random (Source);
         end loop;
         R.Monitor.Send (Text);
         if Round mod 20 = 0 then
            --  a new session now and then, in the middle of a line
            Mark := R.Supervisor.Log_Length;
            R.Monitor.Reset;
            R.Supervisor.Expect_Log ("session closed", After => Mark);
            Connect (R);
         end if;
      end loop;
      Expect_Alive (R);
   end Random_Bytes;

   procedure Random_Commands is
      --  Every command in every state, without waiting, in sessions that end
      --  anywhere. Each is answered once: counted. RGBT is omitted, as its
      --  answer looks like the unsolicited level.
      R        : Rig;
      All_Words : constant Arguments := Words
        ("ROPN RCLS RSOW RSWW RRST RPIN RLDW RGFW RGBW RGLF RGRI RSTP"
         & " MABT MGTO:320;240 MPCM:20;20;60;40"
         & " RMOV:40 RTRN:-40 RGST COPN CCLS CPCO CPST nope");
      State    : Natural := 4242;
      Answers  : constant String := "AACK ANAK ACRJ ACER ATIM RCST";
      Asked    : constant := 150;
      Mark     : Natural;

      function Next_Random (Limit : Positive) return Natural is
      begin
         State := (State * 1_103 + 12_345) mod 1_000_003;
         return State mod Limit;
      end Next_Random;

   begin
      Assemble (R, Camera => True, Emulator_Options => "--baud 0");
      for Session in 1 .. 4 loop
         for Number in 1 .. Asked loop
            R.Monitor.Send_Line
              (All_Words.Element
                 (1 + Next_Random (Natural (All_Words.Length))));
            if Next_Random (10) = 0 then
               delay 0.01;
            end if;
         end loop;
         R.Monitor.Await (Answers, Asked);
         R.Monitor.Expect_Silence (Answers, 0.2);
         Mark := R.Supervisor.Log_Length;
         R.Monitor.Reset;
         R.Supervisor.Expect_Log ("session closed", After => Mark);
         R.Emulator.Await_Status ("moving", "0");
         Connect (R);
      end loop;
      Expect_Alive (R);
   end Random_Commands;

   procedure Garbage_From_Robot is
      R    : Rig;
      Item : Message;
   begin
      Assemble (R, Emulator_Options => "--baud 0");
      Start_Robot (R, Watchdog => True);
      for Round in 1 .. 60 loop
         R.Emulator.Tell ("unasked " & (1 .. 40 => Character'Val (33 + Round))
                          & "\r\r\x00\xFF\n");
         if Round mod 5 = 0 then
            R.Emulator.Tell ("garbage 1");
         end if;
         R.Monitor.Skip_To_Now;
         R.Monitor.Send_Line ("RGST");
         Item := R.Monitor.Next_Answer ("RGST");
         Check (Item.Label in "ATIM" | "ANAK"
                or else (Item.Label = "RCST" and then Item.Data = "0"),
                Item.Label & ":" & To_String (Item.Data)
                & " made out of garbage");
      end loop;
      --  what a line that has been closed meanwhile has not delivered
      R.Emulator.Tell ("garbage 0");
      --  which has heard that once it answers
      R.Emulator.Await_Status ("moving", "0");
      R.Monitor.Expect ("RCLS", "AACK");
      Expect_Alive (R);
   end Garbage_From_Robot;

   procedure Answers_Kept_For_A_Stalled_Monitor is
      --  While images wait, too: none of the answers is dropped
      Count : constant := 600;
      R     : Rig;
      Item  : Message;
      Text  : Unbounded_String;
   begin
      Assemble (R, Camera => True, Emulator_Options => "--baud 0",
                Connected => False);
      R.Monitor.Connect (R.Supervisor.Port, Receive_Buffer => 8_192);
      R.Monitor.Expect ("ROPN", "AACK");
      Open_Camera (R);
      R.Monitor.Pause;
      delay 1.0;
      for Number in 1 .. Count loop
         Append (Text, (if Number mod 3 = 0 then "RPIN" else "nope")
                 & ASCII.LF);
      end loop;
      R.Monitor.Send (To_String (Text));
      delay 3.0;
      R.Monitor.Skip_To_Now;
      R.Monitor.Resume;
      for Number in 1 .. Count loop
         Item := R.Monitor.Next_Answer;
         Check (Item.Label = (if Number mod 3 = 0 then "AACK" else "ACER"),
                "answer" & Number'Image & " is " & Item.Label);
      end loop;
      Item := R.Monitor.Next_Of ("CIMG");
      Check (R.Monitor.Broken_Images = 0, "a broken image");
   end Answers_Kept_For_A_Stalled_Monitor;

   procedure Flat_Over_Cycles is
      --  Opening and closing, losing and finding again
      R           : Rig;
      Memory      : Natural := 0;
      Descriptors : Natural := 0;

   begin
      Assemble (R, Emulator_Options => "--baud 0", Terminal => True);
      for Number in 1 .. 60 loop
         Play (R, "ROPN AACK, RSWW AACK, RMOV:5 AACK, RCLS AACK, ROPN AACK,"
               & " tell hangup, RCLS AACK, ROPN ANAK, tell return");
         if Number = 20 then
            Memory := Process_Facts.Resident_Kilobytes (R.Supervisor.Pid);
            Descriptors := Process_Facts.Descriptors (R.Supervisor.Pid);
         end if;
      end loop;
      Check (Process_Facts.Resident_Kilobytes (R.Supervisor.Pid)
             <= Memory + 512, "memory grows");
      Check (Process_Facts.Descriptors (R.Supervisor.Pid) = Descriptors,
             "descriptors before and after differ");
   end Flat_Over_Cycles;

   procedure Flat_Over_Large_Images is
      --  Buffers for images of another size are returned to the system,
      --  whichever task and frame slot had them
      Before : constant := 4;    --  rounds until ordinary images need no more
      Rounds : constant := 8;
      Last   : constant := 4;    --  rounds: what is kept is there after each,
                                 --  what a search has just freed is not
      Kept   : constant := 768;  --  kB: an image of 640 x 480 has 900
      R      : Rig;
      Memory : Natural;
      After  : Natural := Natural'Last;

      procedure Change_Size (Size : String) is
         --  The first one has been drawn
         Drawn    : constant Natural := R.Emulator.Status_Number ("frames");
         Deadline : constant Instant := Now + Patience;
      begin
         R.Emulator.Tell ("camera size " & Size);
         while R.Emulator.Status_Number ("frames") < Drawn + 2 loop
            Check (Now < Deadline, "no image is drawn");
            delay 0.01;
         end loop;
      end Change_Size;

   begin
      Assemble (R, Camera => True);
      for Number in 1 .. Before loop
         Open_Camera (R, Positions => True);
         R.Monitor.Await ("CIMG", 12);
         --  each of the frame slots has had one
         R.Monitor.Expect ("CCLS", "AACK");
      end loop;
      Memory := Process_Facts.Resident_Kilobytes (R.Supervisor.Pid);
      for Number in 1 .. Rounds loop
         Open_Camera (R, Positions => True);
         --  not faster than a busy processor can keep up with
         R.Emulator.Tell ("camera fps 3");
         Change_Size ("3840x2160");
         R.Monitor.Await ("CIMG", 3);
         Change_Size ("1600x1200");
         R.Monitor.Await ("CIMG", 2);
         R.Emulator.Tell ("camera mend");
         R.Monitor.Await ("CIMG", 12);
         R.Monitor.Expect ("CCLS", "AACK");
         if Number > Rounds - Last then
            After :=
              Natural'Min
                (After,
                 Process_Facts.Resident_Kilobytes (R.Supervisor.Pid));
         end if;
      end loop;
      Note (Memory'Image & " kB, then" & After'Image & " kB");
      Check (After <= Memory + Kept, "memory grows");
   end Flat_Over_Large_Images;

begin
   Add ("Never_Crashes_On_Malformed_Commands", Malformed_Commands'Access);
   Add ("Never_Crashes_On_Superfluous_Data", Superfluous_Data'Access);
   Add ("Never_Crashes_On_A_Line_Without_End", Line_Without_End'Access);
   Add ("Never_Crashes_On_Random_Bytes", Random_Bytes'Access);
   Add ("Never_Crashes_On_Random_Commands", Random_Commands'Access);
   Add ("Never_Crashes_On_Garbage_From_The_Robot", Garbage_From_Robot'Access);
   Add ("Never_Drops_An_Answer", Answers_Kept_For_A_Stalled_Monitor'Access);
   Add ("Never_Grows_In_Cycles", Flat_Over_Cycles'Access);
   Add ("Never_Keeps_The_Memory_Of_Large_Images",
        Flat_Over_Large_Images'Access, Timed => True);
end Never_Tests;
