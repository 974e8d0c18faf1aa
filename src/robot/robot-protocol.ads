--  SPDX-License-Identifier: GPL-3.0-or-later
--  The protocol of the robot: encodes commands as frames, and decodes received
--  frames as the answers to them.

with Bytes;    use Bytes; use type Bytes.Byte;
with Commands;
with Decimals;

package Robot.Protocol with SPARK_Mode is

   pragma Assertion_Policy (Subprogram_Variant => Ignore);
   --  Proved; GNAT 12 cannot compile the run-time check.

   --  Commands

   type Command_Kind is
     (Ping,
      Reset,
      Start,
      Start_Watchdog,
      Reload,
      Battery,
      Busy,
      Version,
      Power_Off,
      Move,
      Turn,
      Unknown_Letter);
   --  Unknown_Letter sends a letter that no firmware knows, answered by
   --  "unknown command". It is the probe when late answers of all other
   --  classes may arrive.

   type Command is record
      Kind  : Command_Kind      := Ping;
      Value : Commands.Argument := 0;
   end record;
   --  Value is used by Move and Turn only.

   Stop : constant Command := (Move, 0);

   subtype With_Argument is Command_Kind range Move .. Turn;

   function Letter (Kind : Command_Kind) return Character is
     (case Kind is
         when Ping           => 'p',
         when Reset          => 'r',
         when Start          => 'u',
         when Start_Watchdog => 'W',
         when Reload         => 'w',
         when Battery        => 'v',
         when Busy           => 'b',
         when Version        => 'V',
         when Power_Off      => 'z',
         when Move           => 'M',
         when Turn           => 'T',
         when Unknown_Letter => '?');

   --  Frames

   Max_Frame : constant := 50;
   --  Bytes, as in the firmware, whose buffer wraps for longer frames.

   Terminator : constant Byte := 16#0D#;

   subtype Frame_Length is Natural range 0 .. Max_Frame + 1;
   --  Max_Frame + 1: it is too long

   type Frame is record
      Data   : Byte_Array (1 .. Frame_Length'Last) := (others => 0);
      Length : Frame_Length                        := 0;
   end record;
   --  The first Length bytes of Data are valid.

   function Parity (Data : Byte_Array; Last : Natural) return Byte is
     (if Last = 0 then 0
      else Parity (Data, Last - 1) xor Data (Last))
   with
     Pre => Data'First = 1
       and then Last <= Data'Last
       and then Last <= Max_Frame,
     Subprogram_Variant => (Decreases => Last);
   --  The exclusive or of the first Last bytes.

   function Checksum (Data : Byte_Array; Length : Natural) return Byte is
     (if Parity (Data, Length) = Terminator then 16#0E#
      else Parity (Data, Length))
   with
     Pre  => Data'First = 1
       and then Length <= Data'Last
       and then Length <= Max_Frame,
     Post => Checksum'Result /= Terminator;
   --  The checksum of the first Length bytes.

   function Is_Framed (F : Frame) return Boolean is
     (F.Length >= 3
      and then F.Data (F.Length) = Terminator
      and then
        (for all I in 1 .. F.Length - 1 => F.Data (I) /= Terminator)
      and then F.Data (F.Length - 1) = Checksum (F.Data, F.Length - 2));
   --  Text, checksum and terminator, with no terminator before the end.

   --  Used in the contract of Encode

   package Byte_Decimals is new Decimals (Byte, Byte_Array);

   function Has_Number
     (F : Frame; First : Positive; Number : Byte_Decimals.Number)
      return Boolean
   is (F.Length - First in 2 .. 7
       and then Byte_Decimals.Is_Numeral (F.Data, First, F.Length - 2)
       and then Byte_Decimals.Value (F.Data, First, F.Length - 2) = Number);
   --  The text is Number from the byte First on.

   function Is_Text_Of (F : Frame; C : Command) return Boolean is
     (F.Data (1) = Character'Pos (Letter (C.Kind))
      and then
        (if C.Kind not in With_Argument then F.Length = 3
         else F.Data (2) = Character'Pos ('=')
           and then
             (if C.Value >= 0 then Has_Number (F, 3, C.Value)
              else F.Data (3) = Character'Pos ('-')
                and then Has_Number (F, 4, -C.Value))));
   --  The text is the letter of C, and its value in decimal if it has one.

   function Is_Movement (C : Command) return Boolean is
     (C.Kind in With_Argument and then C /= Stop);
   --  The command moves the robot.

   procedure Encode (C : Command; F : out Frame)
   with
     Post => F.Length <= 10 and then Is_Framed (F) and then Is_Text_Of (F, C);
   --  The frame of C, and of no other command: their letters differ.

   --  Replies

   type Reply_Kind is
     (Done,             --  O
      Level,            --  0 .. 2, after Battery
      Moving_State,     --  0, 1, after Busy
      Version_Text,     --  after Version
      Refused,          --  E: wrong state, or bad checksum received
      Unknown_Command,  --  C
      Bad_Checksum,
      Wrong_Kind,       --  valid frame, but no answer to this command
      Malformed);       --  too short for a text and its checksum, or too long

   subtype Accepted_Reply is Reply_Kind range Done .. Version_Text;

   subtype Failed_Reply is Reply_Kind range Bad_Checksum .. Malformed;
   --  Not an answer: the exchange failed.

   type Reply is record
      Kind  : Reply_Kind           := Malformed;
      Value : Integer range 0 .. 2 := 0;
   end record;
   --  Value is the digit of a Level or a Moving_State, otherwise 0.

   type Answer_Class is (Acknowledge, Digit, Text, Unknown);
   --  Classes of answers by form: no text belongs to two of them.

   function Class_Of (Kind : Command_Kind) return Answer_Class is
     (case Kind is
         when Ping .. Reload | Power_Off .. Turn => Acknowledge,
         when Battery | Busy                     => Digit,
         when Version                            => Text,
         when Unknown_Letter                     => Unknown);
   --  The class of the answer if the robot has understood the command.

   function Is_Answer
     (Reply : Reply_Kind; Pending : Command_Kind) return Boolean
   is (case Reply is
          when Done            => Class_Of (Pending) = Acknowledge,
          when Level           => Pending = Battery,
          when Moving_State    => Pending = Busy,
          when Version_Text    => Pending = Version,
          when Unknown_Command => Pending = Unknown_Letter,
          when others          => False);
   --  Whether Reply has the class of Pending: the answer that a probe waits
   --  for. Refused never has, since any command damaged on the line is
   --  refused.

   --  A received frame has no terminator: its text and the checksum

   procedure Append (F : in out Frame; B : Byte)
   with
     Post => F.Length = Natural'Min (F'Old.Length + 1, Max_Frame + 1)
       and then
         (for all I in 1 .. F.Length =>
            (if I <= F'Old.Length then F.Data (I) = F'Old.Data (I)
             else F.Data (I) = B));
   --  B has come from the line, and is not the terminator. May be NUL, since a
   --  checksum may: the robot drops NUL bytes, but no command has such a
   --  checksum.

   function Text_Length (F : Frame) return Commands.Answer_Length is
     (if F.Length in 1 .. Max_Frame then F.Length - 1 else 0);
   --  Bytes before the checksum; 0 if there is no text, or it is too long.

   function Text_Of (F : Frame) return Commands.Answer_Text;

   function Is_Sound (F : Frame) return Boolean is
     (F.Data (Text_Length (F) + 1) = Checksum (F.Data, Text_Length (F)));
   --  The checksum is right.

   function Is_Character (F : Frame; C : Character) return Boolean is
     (Text_Length (F) = 1 and then F.Data (1) = Character'Pos (C));
   --  The text is the single character C.

   function Is_Version (F : Frame) return Boolean is
     (Text_Length (F) >= 2
      and then F.Data (1) in Character'Pos ('0') .. Character'Pos ('9')
      and then (for all I in 1 .. Text_Length (F) =>
                  F.Data (I) in Character'Pos (' ') .. Character'Pos ('~'))
      and then (for some I in 1 .. Text_Length (F) =>
                  F.Data (I) = Character'Pos ('.')));
   --  The text is a version such as 3.5: it begins with a digit and has a
   --  point, so no answer of another class is taken for it, nor two answers in
   --  one frame.

   function Decode (F : Frame; Pending : Command_Kind) return Reply is
     (if Text_Length (F) = 0 then (Malformed, 0)
      elsif not Is_Sound (F) then (Bad_Checksum, 0)
      elsif Is_Character (F, 'E') then (Refused, 0)
      elsif Is_Character (F, 'C') then (Unknown_Command, 0)
      elsif Is_Character (F, 'O') and then Class_Of (Pending) = Acknowledge
      then (Done, 0)
      elsif Class_Of (Pending) = Digit
        and then (Is_Character (F, '0') or else Is_Character (F, '1')
                  or else (Is_Character (F, '2') and then Pending = Battery))
      then ((if Pending = Battery then Level else Moving_State),
            Integer (F.Data (1)) - Character'Pos ('0'))
      elsif Is_Version (F) and then Pending = Version then (Version_Text, 0)
      else (Wrong_Kind, 0));
   --  The meaning of frame F as the answer to Pending. Every frame has one.

end Robot.Protocol;
