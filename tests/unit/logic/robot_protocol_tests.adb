--  SPDX-License-Identifier: GPL-3.0-or-later
--  The robot's frames: every command, every argument, every short answer.

with Ada.Numerics.Discrete_Random;
with Ada.Strings.Fixed;

with AUnit.Assertions; use AUnit.Assertions;

with Bytes;            use Bytes;
with Robot.Protocol;   use Robot.Protocol;
with Unit_Runs; use Unit_Runs;

package body Robot_Protocol_Tests is

   use type Byte;

   package Random_Bytes is new Ada.Numerics.Discrete_Random (Byte);

   CR : constant Byte := 16#0D#;

   function Frame_Of (Text : String) return Frame;
   --  Text, its checksum computed here and not by the package, and the
   --  terminator.

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

   function Answered (Text : String; Pending : Command_Kind) return Reply is
      --  The meaning of a sound frame with Text.
      R : Reply;
   begin
      Decode (Frame_Of (Text), Pending, R);
      return R;
   end Answered;

   procedure Check_Command (C : Command; Text : String) is
      --  C is framed as Text and read back.
      F : Frame;
   begin
      Encode (C, F);
      Assert (F = Frame_Of (Text), "frame of " & Text);
      Assert (Decoded (F) = (True, C), "read back " & Text);
   end Check_Command;

   function Frame_Of (Text : String) return Frame is
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

   procedure Test_Arguments is

      function Image (N : Integer) return String is
        (Ada.Strings.Fixed.Trim (N'Image, Ada.Strings.Left));

   begin
      for N in Argument loop
         Check_Command ((Move, N), "M=" & Image (N));
         Check_Command ((Turn, N), "T=" & Image (N));
      end loop;
   end Test_Arguments;

   procedure Test_Bad_Checksum is
      F : Frame;
      R : Reply;
   begin
      for Text in 1 .. 6 loop
         declare
            Good : constant Frame :=
              Frame_Of (case Text is
                           when 1      => "O",
                           when 2      => "E",
                           when 3      => "C",
                           when 4      => "0",
                           when 5      => "2",
                           when others => "3.5");
         begin
            for Wrong in Byte range 1 .. 255 loop
               for K in Command_Kind loop
                  F := Good;
                  F.Data (F.Length - 1) :=
                    F.Data (F.Length - 1) xor Wrong;
                  if F.Data (F.Length - 1) /= CR then
                     Decode (F, K, R);
                     Assert (R = (Bad_Checksum, 0), "checksum off");
                  end if;
               end loop;
            end loop;
         end;
      end loop;
   end Test_Bad_Checksum;

   procedure Test_Chaos is
      G     : Random_Bytes.Generator;
      F     : Frame;
      R     : Reply;
      Seen  : array (Reply_Kind) of Natural := (others => 0);
      Frank : Reading;
   begin
      Random_Bytes.Reset (G, 5);
      for Round in 1 .. 200_000 loop
         F.Length := Natural (Random_Bytes.Random (G)) mod 51;
         for I in 1 .. F.Length loop
            F.Data (I) := Random_Bytes.Random (G);
            if Round mod 2 = 0 then
               F.Data (I) := 45 + F.Data (I) mod 5;
            end if;
         end loop;
         if Round mod 3 = 0 and then F.Length >= 2 then
            F.Data (F.Length) := Checksum (F.Data, F.Length - 1);
         end if;
         Decode (F, Command_Kind'Val (Round / 6 mod 12), R);
         Seen (R.Kind) := Seen (R.Kind) + 1;
         Frank := Decoded (F);
         Assert (not Frank.OK or else Is_Framed (F), "no command");
      end loop;
      Assert (Seen (Malformed) > 0 and then Seen (Bad_Checksum) > 0
              and then Seen (Wrong_Kind) > 0 and then Seen (Version_Text) > 0,
              "kinds seen");
   end Test_Chaos;

   procedure Test_Checksum is
      Data : Byte_Array (1 .. 50) := (others => 0);
   begin
      Assert (Checksum (Data, 0) = 0, "of nothing");
      for A in Byte loop
         for B in Byte loop
            Data (1) := A;
            Data (2) := B;
            Assert (Checksum (Data, 2)
                      = (if (A xor B) = CR then 16#0E# else A xor B),
                    "of two bytes");
            Assert (Checksum (Data, 50) = Checksum (Data, 2),
                    "zeros change nothing");
         end loop;
         Assert (Checksum (Data, 1) = (if A = CR then 16#0E# else A),
                 "of one byte");
      end loop;
   end Test_Checksum;

   procedure Test_Classes is

      function Reply_To (K : Command_Kind; R : Reply_Kind) return Boolean
      is (Is_Answer (R, K));

   begin
      for K in Command_Kind loop
         Assert (Class_Of (K)
                   = (case K is
                         when Battery | Busy => Digit,
                         when Version        => Text,
                         when Unknown_Letter => Unknown,
                         when others         => Acknowledge),
                 "class of " & K'Image);
         for R in Reply_Kind loop
            Assert (Reply_To (K, R)
                      = (case K is
                            when Battery        => R = Level,
                            when Busy           => R = Moving_State,
                            when Version        => R = Version_Text,
                            when Unknown_Letter => R = Unknown_Command,
                            when others         => R = Done),
                    K'Image & " and " & R'Image);
         end loop;
      end loop;
   end Test_Classes;

   procedure Test_Decoded is

      procedure Refuse (Text : String) is
         --  Text, soundly framed, is no command.
      begin
         Assert (not Decoded (Frame_Of (Text)).OK, "no command: " & Text);
      end Refuse;

      F : Frame;
   begin
      Refuse ("");
      Refuse ("x");
      Refuse ("P");
      Refuse ("pp");
      Refuse ("M");
      Refuse ("M=");
      Refuse ("M=-");
      Refuse ("M12");
      Refuse ("M=32768");
      Refuse ("M=-32769");
      Refuse ("T=123456");
      Refuse ("T=-123456");
      Refuse ("T= 12");
      Refuse ("T=+12");
      Refuse ("T=1-2");
      Refuse ("T=--2");
      Assert (Decoded (Frame_Of ("M=007")) = (True, (Move, 7)), "zeros");
      Assert (Decoded (Frame_Of ("T=-0")) = (True, (Turn, 0)), "minus 0");

      F := Frame_Of ("p");
      F.Length := 2;
      Assert (not Decoded (F).OK, "no terminator");
      F.Length := 0;
      Assert (not Decoded (F).OK, "empty");
      F := Frame_Of ("M=10");
      F.Data (3) := CR;
      Assert (not Decoded (F).OK, "terminator inside");
      F := Frame_Of ("v");
      F.Data (2) := 0;
      Assert (not Decoded (F).OK, "checksum");
   end Test_Decoded;

   procedure Test_Directions is
   begin
      Check_Command (Forward, "M=32767");
      Check_Command (Backward, "M=-32768");
      Check_Command (Left, "T=32767");
      Check_Command (Right, "T=-32768");
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
      Assert (Decoded (F) = (True, (Ping, 0)), "none read back");
   end Test_Letters;

   procedure Test_Malformed is
      F : Frame;
      R : Reply;
   begin
      for K in Command_Kind loop
         F := (Length => 0, Data => (others => 79));
         Decode (F, K, R);
         Assert (R = (Malformed, 0), "empty");
         for B in Byte loop
            F := (Length => 1, Data => (B, others => 79));
            Decode (F, K, R);
            Assert (R = (Malformed, 0), "one byte");
            F := (Length => 2, Data => (B, CR, others => 79));
            Decode (F, K, R);
            Assert (R = (Malformed, 0), "one byte and the terminator");
         end loop;
      end loop;
   end Test_Malformed;

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
      for N in Argument loop
         Encode ((Move, N), F);
         Assert (F.Data (F.Length - 1) /= 0, "move");
         Encode ((Turn, N), F);
         Assert (F.Data (F.Length - 1) /= 0, "turn");
      end loop;
      Assert (Answered (Text, Version).Kind = Version_Text, "printable");
   end Test_Nul;

   procedure Test_One_Character is

      function Expected (C : Character; K : Command_Kind) return Reply is
        (case C is
            when 'E' => (Refused, 0),
            when 'C' => (Unknown_Command, 0),
            when 'O' =>
              (if K in Battery | Busy | Version | Unknown_Letter
               then (Wrong_Kind, 0) else (Done, 0)),
            when '0' | '1' =>
              (case K is
                  when Battery => (Level, Character'Pos (C) - 48),
                  when Busy    => (Moving_State, Character'Pos (C) - 48),
                  when others  => (Wrong_Kind, 0)),
            when '2' =>
              (if K = Battery then (Level, 2) else (Wrong_Kind, 0)),
            when others => (Wrong_Kind, 0));

      F : Frame;
      R : Reply;
   begin
      for K in Command_Kind loop
         for C in Character loop
            F := Frame_Of ((1 => C));
            Decode (F, K, R);
            Assert (R = Expected (C, K), K'Image & " with terminator");
            F.Length := F.Length - 1;
            Decode (F, K, R);
            Assert (R = Expected (C, K), K'Image & " without terminator");
         end loop;
      end loop;
   end Test_One_Character;

   procedure Test_Overflow is
      Rec      : Receiver;
      F        : Frame;
      R        : Reply;
      Complete : Boolean;
   begin
      --  As long as a frame may be

      for I in 1 .. Max_Frame loop
         Accept_Byte (Rec, 65, Complete);
         Assert (not Complete and then not Rec.Overflow, "not full");
      end loop;
      Accept_Byte (Rec, CR, Complete);
      Get (Rec, F);
      Assert (Complete and then F.Length = Max_Frame
              and then (for all B of F.Data => B = 65), "full");

      --  One more, and many more

      for Extra in 1 .. 300 loop
         for I in 1 .. Max_Frame + Extra loop
            Accept_Byte (Rec, 66, Complete);
            Assert (not Complete, "endless");
         end loop;
         Assert (Rec.Overflow and then Rec.Length = Max_Frame, "overflow");
         Accept_Byte (Rec, CR, Complete);
         Get (Rec, F);
         Decode (F, Ping, R);
         Assert (Complete and then F.Length = 0
                 and then R = (Malformed, 0), "malformed");
      end loop;

      --  The frame behind it is sound

      for B of Byte_Array'(79, 79) loop
         Accept_Byte (Rec, B, Complete);
      end loop;
      Accept_Byte (Rec, CR, Complete);
      Get (Rec, F);
      Decode (F, Ping, R);
      Assert (Complete and then R = (Done, 0), "next");
   end Test_Overflow;

   procedure Test_Receiver is
      Rec      : Receiver;
      F        : Frame;
      R        : Reply;
      Complete : Boolean;
   begin
      Accept_Byte (Rec, CR, Complete);
      Get (Rec, F);
      Decode (F, Ping, R);
      Assert (Complete and then F.Length = 0 and then R.Kind = Malformed,
              "an empty frame");
      for Round in 1 .. 3 loop
         Accept_Byte (Rec, 79, Complete);
         Assert (not Complete, "O");
         Accept_Byte (Rec, 79, Complete);
         Assert (not Complete, "checksum");
         Accept_Byte (Rec, CR, Complete);
         Get (Rec, F);
         Decode (F, Ping, R);
         Assert (Complete and then F.Length = 2 and then R = (Done, 0),
                 "a frame in three pieces");
      end loop;
      Accept_Byte (Rec, 69, Complete);
      Clear (Rec);
      Accept_Byte (Rec, 50, Complete);
      Accept_Byte (Rec, 50, Complete);
      Accept_Byte (Rec, CR, Complete);
      Get (Rec, F);
      Decode (F, Battery, R);
      Assert (Complete and then R = (Level, 2), "cleared in between");
   end Test_Receiver;

   procedure Test_Stream is
      G        : Random_Bytes.Generator;
      Rec      : Receiver;
      F        : Frame;
      B        : Byte;
      Kept     : Byte_Array (1 .. 600) := (others => 0);
      Count    : Natural := 0;
      Complete : Boolean;
   begin
      Random_Bytes.Reset (G, 6);
      for Round in 1 .. 200_000 loop
         B := Random_Bytes.Random (G);
         if Count = 600 then
            B := CR;
         end if;
         Accept_Byte (Rec, B, Complete);
         Assert (Complete = (B = CR), "ends at the terminator");
         if Complete then
            Get (Rec, F);
            Assert (F.Length = (if Count > 50 then 0 else Count)
                    and then F.Data (1 .. F.Length) = Kept (1 .. F.Length),
                    "bytes as they came");
            Count := 0;
         else
            Count := Count + 1;
            Kept (Count) := B;
         end if;
      end loop;
   end Test_Stream;

   procedure Test_Two_Bytes is
      F : Frame;
      R : Reply;
   begin
      for A in Byte loop
         for B in Byte loop
            F := (Length => 2, Data => (A, B, others => 0));
            for K in Command_Kind loop
               Decode (F, K, R);
               if B = CR then
                  Assert (R = (Malformed, 0), "a lone byte");
               elsif B /= Plain_Checksum ((1 => Character'Val (A))) then
                  Assert (R = (Bad_Checksum, 0), "no checksum");
               else
                  Assert (R = Answered ((1 => Character'Val (A)), K),
                          "as with its terminator");
               end if;
            end loop;
         end loop;
      end loop;
   end Test_Two_Bytes;

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

   procedure Add_Tests is
   begin
      Add_Test ("command letters", Test_Letters'Access);
      Add_Test ("directions", Test_Directions'Access);
      Add_Test ("every argument", Test_Arguments'Access);
      Add_Test ("checksum, never 0x0D", Test_Checksum'Access);
      Add_Test ("frames of no command", Test_Decoded'Access);
      Add_Test ("classes of answers", Test_Classes'Access);
      Add_Test ("table of answers", Test_Answers'Access);
      Add_Test ("every command, every character", Test_One_Character'Access);
      Add_Test ("every command, every two bytes", Test_Two_Bytes'Access);
      Add_Test ("version texts", Test_Versions'Access);
      Add_Test ("too short", Test_Malformed'Access);
      Add_Test ("bad checksums", Test_Bad_Checksum'Access);
      Add_Test ("chaos", Test_Chaos'Access);
      Add_Test ("receiving", Test_Receiver'Access);
      Add_Test ("frames that do not end", Test_Overflow'Access);
      Add_Test ("a checksum of NUL", Test_Nul'Access);
      Add_Test ("a random stream", Test_Stream'Access);
   end Add_Tests;

end Robot_Protocol_Tests;
