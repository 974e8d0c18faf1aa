--  SPDX-License-Identifier: GPL-3.0-or-later
--  What must never happen, for any input.

with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Child_Processes;       use Child_Processes;
with Expectations;          use Expectations;
with Instants;              use Instants;
with Monitor_Clients;       use Monitor_Clients;
with Process_Facts;         use Process_Facts;
with Random_Numbers;        use Random_Numbers;
with Rigs;                  use Rigs;
with Scenarios;             use Scenarios;

procedure Never_Tests is

   Alive : constant String :=
     "RCLS AACK, " & Started & ", RGFW AACK, RSTP AACK, RCLS AACK";
   --  A new session works

   procedure Malformed_Commands (R : in out Rig) is

      procedure Refuse (Line : String) is
      begin
         R.Monitor.Expect (Line, "ACER");
      end Refuse;

   begin
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
      Play (R, "wire, " & Alive);
   end Malformed_Commands;

   procedure Superfluous_Data (R : in out Rig) is
      --  Data after a command that takes none: carried out or rejected, one
      --  answer in both cases
      Item : Message;
   begin
      for Name of Words
        ("ROPN RSOW RSWW RRST RPIN RLDW RGFW RGBW RGLF RGRI RSTP MABT RPOF"
         & " RGBT RGST RCLS COPN CPCO CPST CCLS")
      loop
         for Data of Words
           (": :1 :-99999999999999999999999 :x;y :%s%n%n :::: :"
            & (1 .. 500 => 'q'))
         loop
            R.Monitor.Skip_To_Now;
            R.Monitor.Send_Line (Name & Data & ASCII.LF & "nope");
            Item := R.Monitor.Next_Answer (Name);
            loop
               Item := R.Monitor.Next_Answer (Name);
               --  the battery may have come unsolicited before the answer
               exit when Item.Label /= "RBLV";
            end loop;
            Check_Label (Item, "ACER", "after the answer to " & Name & Data);
         end loop;
      end loop;
      Play (R, "tell reset-robot, status state idle, " & Alive);
   end Superfluous_Data;

   procedure Line_Without_End (R : in out Rig) is
      Piece  : constant String (1 .. 64 * 1024) := (others => 'x');
      Before : constant Footprint := Footprint_Of (R.Supervisor.Pid);
   begin
      for Number in 1 .. 32 loop
         R.Monitor.Send (Piece);
      end loop;
      R.Monitor.Skip_To_Now;
      R.Monitor.Send ((1 => ASCII.LF));
      Play (R, "answer ACER, silence 0.3 ACER AACK ANAK");
      Expect_Flat (R.Supervisor.Pid, Before);
      Play (R, Alive);
   end Line_Without_End;

   procedure Random_Bytes (R : in out Rig) is
      Source : Generator;
      Text   : String (1 .. 1_000);
   begin
      Start (Source, 5544, "bytes");
      for Session in 1 .. 10 loop
         R.Monitor.Expect ("RPIN", "ANAK");
         for Round in 1 .. 20 loop
            for Place of Text loop
               Place := Character'Val (Whole (Source, 0, 255));
            end loop;
            R.Monitor.Send (Text);
         end loop;
         --  in the middle of a line
         Play (R, "reset, log session closed, connect");
      end loop;
      Play (R, Alive);
   end Random_Bytes;

   procedure Random_Commands (R : in out Rig) is
      --  Every command in every state, without waiting, in sessions that end
      --  anywhere. Each is answered once: counted. RGBT is omitted, as its
      --  answer looks like the unsolicited level.
      All_Words : constant Arguments := Words
        ("ROPN RCLS RSOW RSWW RRST RPIN RLDW RGFW RGBW RGLF RGRI RSTP"
         & " MABT MGTO:320;240 MPCM:20;20;60;40"
         & " RMOV:40 RTRN:-40 RGST COPN CCLS CPCO CPST nope");
      Labels    : constant String := Answers & " RCST";
      Asked     : constant := 150;
      Source    : Generator;

   begin
      Start (Source, 4242, "commands");
      for Session in 1 .. 4 loop
         for Number in 1 .. Asked loop
            R.Monitor.Send_Line
              (All_Words.Element
                 (Whole (Source, 1, All_Words.Last_Index)));
            if Whole (Source, 1, 10) = 1 then
               delay 0.01;
            end if;
         end loop;
         R.Monitor.Await (Labels, Asked);
         Play (R, "silence 0.2 " & Labels & ", reset, log session closed,"
               & " status moving 0, connect");
      end loop;
      Play (R, Alive);
   end Random_Commands;

   procedure Garbage_From_Robot (R : in out Rig) is
      Item : Message;
   begin
      for Round in 1 .. 60 loop
         R.Emulator.Tell ("unasked " & (1 .. 40 => Character'Val (33 + Round))
                          & "\r\r\x00\xFF\n");
         if Round mod 5 = 0 then
            R.Emulator.Tell ("garbage 1");
         end if;
         Item := R.Monitor.Ask ("RGST");
         Check (Item.Label in "ATIM" | "ANAK"
                or else (Item.Label = "RCST" and then Item.Data = "0"),
                Item.Label & ":" & To_String (Item.Data)
                & " made out of garbage");
      end loop;
      --  what a line that has been closed meanwhile has not delivered; the
      --  robot has heard that once it answers
      Play (R, "tell garbage 0, status moving 0, RCLS AACK, " & Alive);
   end Garbage_From_Robot;

   procedure Answers_Kept_For_A_Stalled_Monitor (R : in out Rig) is
      --  While images wait, too: none of the answers is dropped
      Count : constant := 200;
   begin
      R.Monitor.Connect (R.Supervisor.Port, Receive_Buffer => 8_192);
      Play (R, "ROPN AACK, " & With_Images & ", pause, wait 1, send "
            & (Count - 1) * "nope|nope|RPIN|" & "nope|nope|RPIN, wait 3");
      R.Monitor.Skip_To_Now;
      R.Monitor.Resume;
      Play (R, "answer ACER ACER AACK", Times => Count);
      R.Monitor.Await ("CIMG");
      Check (R.Monitor.Broken_Images = 0, "a broken image");
   end Answers_Kept_For_A_Stalled_Monitor;

   procedure Flat_Over_Cycles (R : in out Rig) is
      --  Opening and closing, losing and finding again
      Cycle  : constant String :=
        Guarded & ", RMOV:5 AACK, RCLS AACK, ROPN AACK, tell hangup,"
        & " RCLS AACK, ROPN ANAK, tell return";
      Before : Footprint;
   begin
      Play (R, Cycle, Times => 20);
      Before := Footprint_Of (R.Supervisor.Pid);
      Play (R, Cycle, Times => 40);
      Expect_Flat (R.Supervisor.Pid, Before, Kilobytes => 512);
   end Flat_Over_Cycles;

   procedure Flat_Over_Large_Images (R : in out Rig) is
      --  Buffers for images of another size are returned to the system,
      --  whichever task and frame slot had them
      Before : constant := 4;    --  rounds until ordinary images need no more
      Rounds : constant := 8;
      Last   : constant := 4;    --  rounds: what is kept is there after each,
                                 --  what a search has just freed is not
      Kept   : constant := 768;  --  kB: an image of 640 x 480 has 900
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
      for Number in 1 .. Before loop
         Play (R, With_Positions);
         R.Monitor.Await ("CIMG", 12);
         --  each of the frame slots has had one
         R.Monitor.Expect ("CCLS", "AACK");
      end loop;
      Memory := Resident_Kilobytes (R.Supervisor.Pid);
      for Number in 1 .. Rounds loop
         --  not faster than a busy processor can keep up with
         Play (R, With_Positions & ", tell camera fps 3");
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
                 Resident_Kilobytes (R.Supervisor.Pid));
         end if;
      end loop;
      Note (Memory'Image & " kB, then" & After'Image & " kB");
      Check (After <= Memory + Kept, "memory grows");
   end Flat_Over_Large_Images;

begin
   Script ("Never_Crashes_On_Malformed_Commands", Started & ", clear",
           Malformed_Commands'Access);
   Script ("Never_Crashes_On_Superfluous_Data", "", Superfluous_Data'Access,
           Camera => True);
   Script ("Never_Crashes_On_A_Line_Without_End", "RPIN ANAK",
           Line_Without_End'Access);
   Script ("Never_Crashes_On_Random_Bytes", "", Random_Bytes'Access,
           Emulator_Options => "--baud 0");
   Script ("Never_Crashes_On_Random_Commands", "", Random_Commands'Access,
           Camera => True, Emulator_Options => "--baud 0");
   Script ("Never_Crashes_On_Garbage_From_The_Robot", Guarded,
           Garbage_From_Robot'Access, Emulator_Options => "--baud 0");
   Script ("Never_Drops_An_Answer", "",
           Answers_Kept_For_A_Stalled_Monitor'Access, Camera => True,
           Emulator_Options => "--baud 0", Connected => False);
   Script ("Never_Grows_In_Cycles", "", Flat_Over_Cycles'Access,
           Emulator_Options => "--baud 0", Terminal => True);
   Script ("Never_Keeps_The_Memory_Of_Large_Images", "",
           Flat_Over_Large_Images'Access, Camera => True, Timed => True);
end Never_Tests;
