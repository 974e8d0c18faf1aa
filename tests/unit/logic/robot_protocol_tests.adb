--  SPDX-License-Identifier: GPL-3.0-or-later
--  The robot's frames: every command, every argument, every short answer.

with AUnit.Assertions; use AUnit.Assertions;

with Bytes;            use Bytes;
with Commands;
with Robot.Protocol;   use Robot.Protocol;
with Unit_Runs; use Unit_Runs;

procedure Robot_Protocol_Tests is

   use type Byte;

   CR : constant Byte := 16#0D#;

   function Plain_Checksum (Text : String) return Byte is
      --  The exclusive or, 0x0D replaced by 0x0E.
      Result : Byte := 0;
   begin
      for C of Text loop
         Result := Result xor Character'Pos (C);
      end loop;
      if Result = CR then
         Result := 16#0E#;
      end if;
      return Result;
   end Plain_Checksum;

   function Frame_Of (Text : String) return Frame is
      --  Text, its checksum computed here and not by the package, and the
      --  terminator.
      F : Frame;
   begin
      for C of Text loop
         F.Length := F.Length + 1;
         F.Data (F.Length) := Character'Pos (C);
      end loop;
      F.Data (F.Length + 1) := Plain_Checksum (Text);
      F.Data (F.Length + 2) := CR;
      F.Length := F.Length + 2;
      return F;
   end Frame_Of;

   function Answered (Text : String; Pending : Command_Kind) return Reply is
      --  The meaning of a sound frame with Text.
      R : Reply;
   begin
      Decode (Frame_Of (Text), Pending, R);
      return R;
   end Answered;

   procedure Check_Command (C : Command; Text : String) is
      --  C is framed as Text.
      F : Frame;
   begin
      Encode (C, F);
      Assert (F = Frame_Of (Text), "frame of " & Text);
   end Check_Command;

   procedure Test_Answers is
   begin
      for K in Command_Kind loop
         Assert (Answered ("E", K) = (Refused, 0), "E");
         Assert (Answered ("C", K) = (Unknown_Command, 0), "C");
         Assert (Answered ("O", K)
                   = (if Class_Of (K) = Acknowledge then (Done, 0)
                      else (Wrong_Kind, 0)), "O");
      end loop;
      Assert (Answered ("0", Battery) = (Level, 0), "empty");
      Assert (Answered ("1", Battery) = (Level, 1), "low");
      Assert (Answered ("2", Battery) = (Level, 2), "full");
      Assert (Answered ("3", Battery) = (Wrong_Kind, 0), "no such level");
      Assert (Answered ("0", Busy) = (Moving_State, 0), "standing");
      Assert (Answered ("1", Busy) = (Moving_State, 1), "moving");
      Assert (Answered ("2", Busy) = (Wrong_Kind, 0), "no such state");
      Assert (Answered ("3.5", Version) = (Version_Text, 0), "version");
      Assert (Answered ("3.5", Battery) = (Wrong_Kind, 0), "no level");
      Assert (Answered ("0", Version) = (Wrong_Kind, 0), "no version");
      Assert (Answered ("0", Ping) = (Wrong_Kind, 0), "no answer to ping");
   end Test_Answers;

   procedure Test_Directions is
   begin
      Check_Command ((Move, 32_767), "M=32767");
      Check_Command ((Move, -32_768), "M=-32768");
      Check_Command ((Turn, 32_767), "T=32767");
      Check_Command ((Turn, -32_768), "T=-32768");
      Check_Command (Stop, "M=0");
   end Test_Directions;

   procedure Test_Letters is
      F : Frame;
   begin
      Check_Command ((Ping, 0), "p");
      Check_Command ((Reset, 0), "r");
      Check_Command ((Start, 0), "u");
      Check_Command ((Start_Watchdog, 0), "W");
      Check_Command ((Reload, 0), "w");
      Check_Command ((Battery, 0), "v");
      Check_Command ((Busy, 0), "b");
      Check_Command ((Version, 0), "V");
      Check_Command ((Power_Off, 0), "z");
      Check_Command ((Unknown_Letter, 0), "?");

      --  A value that the command does not take is not sent

      Encode ((Ping, 17), F);
      Assert (F = Frame_Of ("p"), "no value");
   end Test_Letters;

   procedure Test_Nul is
      F        : Frame;
      R        : Reply;
      Rec      : Receiver;
      Complete : Boolean;
      Text     : constant String := "1.1." & Character'Val (33) & "3.";
   begin
      --  A version whose checksum is NUL: 1 ^ . ^ 1 ^ . is 0

      F := Frame_Of ("1.1.");
      Assert (F.Data (5) = 0, "NUL");
      for I in 1 .. F.Length loop
         Accept_Byte (Rec, F.Data (I), Complete);
      end loop;
      Get (Rec, F);
      Decode (F, Version, R);
      Assert (Complete and then R = (Version_Text, 0), "version");

      --  No command has such a checksum: the robot would drop it

      for K in Command_Kind loop
         Encode ((K, 0), F);
         Assert (F.Data (F.Length - 1) /= 0, "command");
      end loop;
      for N in Commands.Argument loop
         Encode ((Move, N), F);
         Assert (F.Data (F.Length - 1) /= 0, "move");
         Encode ((Turn, N), F);
         Assert (F.Data (F.Length - 1) /= 0, "turn");
      end loop;
      Assert (Answered (Text, Version).Kind = Version_Text, "printable");
   end Test_Nul;

   procedure Test_Versions is
      Long : String (1 .. 48) := (others => '1');
   begin
      Long (2) := '.';
      Assert (Answered ("3.5", Version) = (Version_Text, 0), "3.5");
      Assert (Answered ("12.34b", Version) = (Version_Text, 0), "12.34b");
      Assert (Answered ("1.", Version) = (Version_Text, 0), "1.");
      Assert (Answered (Long, Version) = (Version_Text, 0), "long");
      Assert (Answered (".5", Version) = (Wrong_Kind, 0), "no digit");
      Assert (Answered ("v3.5", Version) = (Wrong_Kind, 0), "letter");
      Assert (Answered ("3." & ASCII.LF, Version) = (Wrong_Kind, 0),
              "not printable");

      --  Answers of other classes that have run together

      Assert (Answered ("222", Version) = (Wrong_Kind, 0), "digits");
      Assert (Answered ("OOO", Version) = (Wrong_Kind, 0), "letters");

      for K in Command_Kind loop
         if K /= Version then
            Assert (Answered ("3.5", K) = (Wrong_Kind, 0), K'Image);
         end if;
      end loop;
   end Test_Versions;

begin
   Run_Test ("command letters", Test_Letters'Access);
   Run_Test ("directions", Test_Directions'Access);
   Run_Test ("table of answers", Test_Answers'Access);
   Run_Test ("version texts", Test_Versions'Access);
   Run_Test ("a checksum of NUL", Test_Nul'Access);
end Robot_Protocol_Tests;
