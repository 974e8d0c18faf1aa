--  SPDX-License-Identifier: GPL-3.0-or-later
--  The robot's frames: every short answer, versions, checksums of NUL.

with Bytes;            use Bytes;
with Commands;
with Robot.Health;     use Robot.Health;
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
      --  The meaning of a sound frame with Text, received.
      F : Frame := Frame_Of (Text);
   begin
      F.Length := F.Length - 1;
      return Decode (F, Pending);
   end Answered;

   procedure Test_Answers is
   begin
      for K in Command_Kind loop
         Assert (Answered ("E", K) = (Refused, 0), "E");
         Assert (Answered ("C", K) = (Unknown_Command, 0), "C");
         Assert (Answered ("O", K)
                   = (if Class_Of (K) = Acknowledge then (Done, 0)
                      else (Wrong_Kind, 0)), "O");
      end loop;
      for Row of Split
        ("0 Battery Level 0|1 Battery Level 1|2 Battery Level 2"
         & "|3 Battery Wrong_Kind 0|0 Busy Moving_State 0"
         & "|1 Busy Moving_State 1|2 Busy Wrong_Kind 0"
         & "|3.5 Version Version_Text 0|3.5 Battery Wrong_Kind 0"
         & "|3.5 Busy Wrong_Kind 0|3.5 Ping Wrong_Kind 0"
         & "|0 Version Wrong_Kind 0|0 Ping Wrong_Kind 0")
      loop
         declare
            Word : constant Line_Vectors.Vector := Split (Row, ' ');
         begin
            Assert (Answered (Word (1), Command_Kind'Value (Word (2)))
                    = (Reply_Kind'Value (Word (3)), Natural'Value (Word (4))),
                    Row);
         end;
      end loop;
   end Test_Answers;

   procedure Test_Late_Answers is
      --  Whatever fails, and whatever any of it is answered in the end, none
      --  of the late answers is taken for the probe's own, which is

      function Said (Kind : Command_Kind; Level : Natural) return String is
        (case Class_Of (Kind) is
            when Acknowledge => "O",
            when Digit       => Level'Image (2 .. 2),
            when Text        => "3.5",
            when Unknown     => "C");
      --  By a robot that understands; Level is its battery's, 0 or 1 whether
      --  it is busy

      H   : State;
      Own : Command_Kind;
   begin
      for First in Command_Kind loop
         for Level in 0 .. 2 loop
            H := After_Failure (Initial, First);
            declare
               Late : Line_Vectors.Vector :=
                 Split ("E|" & Said (First, Level));
            begin
               for Probes in 0 .. 2 loop
                  Own := Probe (H);
                  for Text of Late loop
                     Assert (not Is_Answer (Answered (Text, Own).Kind, Own),
                             Text & " late, of " & First'Image & ", for "
                             & Own'Image);
                  end loop;
                  Assert
                    (Is_Answer (Answered (Said (Own, Level), Own).Kind, Own),
                     "the answer to " & Own'Image);
                  Late.Append (Said (Own, Level));
                  H := After_Failure (H, Own);
               end loop;
            end;
         end loop;
      end loop;
   end Test_Late_Answers;

   procedure Test_Nul is
      F        : Frame;
      Received : Frame;
      Text     : constant String := "1.1." & Character'Val (33) & "3.";
   begin
      --  A version whose checksum is NUL: 1 ^ . ^ 1 ^ . is 0

      F := Frame_Of ("1.1.");
      Assert (F.Data (5) = 0, "NUL");
      for I in 1 .. F.Length - 1 loop
         Append (Received, F.Data (I));
      end loop;
      Assert (Decode (Received, Version) = (Version_Text, 0), "version");

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
      for Text of Split ("3.5|12.34b|1.|" & Long) loop
         Assert (Answered (Text, Version) = (Version_Text, 0), Text);
      end loop;

      --  Answers of other classes that have run together, too

      for Text of Split (".5|v3.5|3." & ASCII.LF & "|222|OOO") loop
         Assert (Answered (Text, Version) = (Wrong_Kind, 0), Text);
      end loop;
   end Test_Versions;

begin
   Run_Test ("table of answers", Test_Answers'Access);
   Run_Test ("version texts", Test_Versions'Access);
   Run_Test ("a checksum of NUL", Test_Nul'Access);
   Run_Test ("a late answer never passes for the next",
             Test_Late_Answers'Access);
end Robot_Protocol_Tests;
