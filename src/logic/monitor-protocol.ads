--  SPDX-License-Identifier: GPL-3.0-or-later
--  The protocol of the monitor: parses its lines, and formats answers.

with Decimals;
with Missions.Paths;
with Robot.Protocol;

package Monitor.Protocol with SPARK_Mode is

   Max_Line : constant := 1024;
   --  Characters of a line from the monitor, without its end.

   Line_Feed : constant Character := Character'Val (10);

   Carriage_Return : constant Character := Character'Val (13);

   Telnet_Mark : constant Character := Character'Val (255);
   --  Telnet commands (RFC 854) begin with it, such as those of a Ctrl-C. They
   --  are skipped where a line begins or ends, and no part of any command.

   --  Messages from the monitor

   type Message_Kind is
     (Open_Robot,
      Close_Robot,
      Start_Robot,
      Start_Robot_Watchdog,
      Reset_Robot,
      Ping_Robot,
      Reload_Watchdog,
      Go_Forward,
      Go_Backward,
      Go_Left,
      Go_Right,
      Stop_Robot,
      Abort_Mission,
      Move_Robot,
      Turn_Robot,
      Power_Off_Robot,
      Get_Battery,
      Get_State,
      Open_Camera,
      Close_Camera,
      Ask_Arena,
      Confirm_Arena,
      Reject_Arena,
      Start_Position,
      Stop_Position,
      Go_To_Pixels,
      Follow_Pixels,
      Go_To_Centimetres,
      Follow_Centimetres,
      Sign_Of_Life,
      Log_Message,
      Malformed);

   subtype Known_Kind is Message_Kind range Open_Robot .. Log_Message;

   subtype Order_Kind is Message_Kind range Open_Robot .. Follow_Centimetres;
   --  Those carried out by a task.

   subtype Mission_Order is
     Order_Kind range Go_To_Pixels .. Follow_Centimetres;
   --  Their data is a path.

   function Measure (Kind : Mission_Order) return Missions.Unit is
     (if Kind in Go_To_Pixels | Follow_Pixels then Missions.Pixels
      else Missions.Centimetres);

   function Is_Single (Kind : Mission_Order) return Boolean is
     (Kind in Go_To_Pixels | Go_To_Centimetres);
   --  The path is one point.

   function Takes_Number (Kind : Message_Kind) return Boolean is
     (Kind in Move_Robot | Turn_Robot);

   function Takes_Text (Kind : Message_Kind) return Boolean is
     (Kind = Log_Message);

   type Message is record
      Kind  : Message_Kind            := Malformed;
      Value : Robot.Protocol.Argument := 0;
   end record;
   --  Value: the argument of Move_Robot and Turn_Robot, otherwise 0.

   function Is_Answered (Kind : Message_Kind) return Boolean is
     (Kind not in Confirm_Arena | Reject_Arena | Sign_Of_Life | Log_Message);
   --  Whether the monitor gets exactly one answer, or none.

   subtype Label_Text is String (1 .. 4);

   function Label (Kind : Known_Kind) return Label_Text is
     (case Kind is
         when Open_Robot           => "ROPN",
         when Close_Robot          => "RCLS",
         when Start_Robot          => "RSOW",
         when Start_Robot_Watchdog => "RSWW",
         when Reset_Robot          => "RRST",
         when Ping_Robot           => "RPIN",
         when Reload_Watchdog      => "RLDW",
         when Go_Forward           => "RGFW",
         when Go_Backward          => "RGBW",
         when Go_Left              => "RGLF",
         when Go_Right             => "RGRI",
         when Stop_Robot           => "RSTP",
         when Abort_Mission        => "MABT",
         when Move_Robot           => "RMOV",
         when Turn_Robot           => "RTRN",
         when Power_Off_Robot      => "RPOF",
         when Get_Battery          => "RGBT",
         when Get_State            => "RGST",
         when Open_Camera          => "COPN",
         when Close_Camera         => "CCLS",
         when Ask_Arena            => "CASA",
         when Confirm_Arena        => "CACO",
         when Reject_Arena         => "CAIN",
         when Start_Position       => "CPCO",
         when Stop_Position        => "CPST",
         when Go_To_Pixels         => "MGTO",
         when Follow_Pixels        => "MPTH",
         when Go_To_Centimetres    => "MGCM",
         when Follow_Centimetres   => "MPCM",
         when Sign_Of_Life         => "LIVE",
         when Log_Message          => "MSSG");

   Token_Label : constant Label_Text := "AUTH";
   --  Of the line with a token, which is read before the session begins.

   Separator : constant Character := ':';
   --  Between a label and its data.

   Text_Offset : constant := 5;
   --  The text of a Log_Message is Line (Line'First + Text_Offset ..
   --  Line'Last); it may be empty. The path of a mission begins there, too.

   --  Used in the contract of Parse

   package Numbers is new Decimals (Character, String);

   function Begins_With (Line : String; Start : Label_Text) return Boolean is
     (Line'Length >= 4
      and then Line (Line'First) = Start (1)
      and then Line (Line'First + 1) = Start (2)
      and then Line (Line'First + 2) = Start (3)
      and then Line (Line'First + 3) = Start (4))
   with Pre => Line'Last < Integer'Last;

   function Has_Data (Line : String) return Boolean is
     (Line'Length >= 5 and then Line (Line'First + 4) = Separator)
   with Pre => Line'Last < Integer'Last;
   --  The label is followed by a separator; the data may be empty.

   function Is_Bare (Line : String; Start : Label_Text) return Boolean is
     (Begins_With (Line, Start)
      and then (Line'Length = 4
                or else (Line'Length = 5 and then Has_Data (Line))))
   with Pre => Line'Last < Integer'Last;
   --  The label alone. The existing monitor appends a separator to every
   --  label, so a separator with nothing after it is accepted.

   function Is_Number
     (Line : String; First : Positive; Last : Natural) return Boolean
   is (Last >= First
       and then
         (if Line (First) in '+' | '-' then
             Last > First and then Numbers.Are_Digits (Line, First + 1, Last)
          else Numbers.Are_Digits (Line, First, Last)))
   with Pre => Line'Last < Integer'Last
     and then First >= Line'First
     and then Last <= Line'Last;
   --  Decimal: an optional sign, then any number of digits. No blanks.

   function Magnitude
     (Line : String; First : Positive; Last : Natural) return Numbers.Number
   is (Numbers.Saturated_Value
         (Line, (if Line (First) in '+' | '-' then First + 1 else First),
          Last))
   with Pre => Line'Last < Integer'Last
     and then First >= Line'First
     and then Last <= Line'Last
     and then Is_Number (Line, First, Last);

   function Clamped_Number
     (Line : String; First : Positive; Last : Natural)
     return Robot.Protocol.Argument
   is (if Line (First) = '-'
       then -Integer'Min (Magnitude (Line, First, Last), 32_768)
       else Integer'Min (Magnitude (Line, First, Last), 32_767))
   with Pre => Line'Last < Integer'Last
     and then First >= Line'First
     and then Last <= Line'Last
     and then Is_Number (Line, First, Last);
   --  The number, limited to the robot's range.

   function Is_Order (Line : String; Start : Label_Text) return Boolean is
     (Begins_With (Line, Start)
      and then Has_Data (Line)
      and then Is_Number (Line, Line'First + Text_Offset, Line'Last))
   with Pre => Line'Last < Integer'Last;
   --  The label, the separator and a number.

   function Is_Mission (Line : String; Kind : Mission_Order) return Boolean
   is (Begins_With (Line, Label (Kind))
       and then Has_Data (Line)
       and then Missions.Paths.Is_Path
         (Line, Line'First + Text_Offset, Is_Single (Kind)))
   with Pre => Line'Last < Integer'Last;
   --  The label, the separator and a path.

   function Is_Line_Of (Line : String; Kind : Known_Kind) return Boolean is
     (if Takes_Number (Kind) then Is_Order (Line, Label (Kind))
      elsif Kind in Mission_Order then Is_Mission (Line, Kind)
      elsif Takes_Text (Kind) then
         Begins_With (Line, Label (Kind)) and then Has_Data (Line)
      else Is_Bare (Line, Label (Kind)))
   with Pre => Line'Last < Integer'Last;

   procedure Parse (Line : String; M : out Message)
   with
     Pre  => Line'Last < Integer'Last,
     Post =>
       (for all K in Known_Kind => (M.Kind = K) = Is_Line_Of (Line, K))
       and then M.Value =
         (if Takes_Number (M.Kind)
          then Clamped_Number (Line, Line'First + Text_Offset, Line'Last)
          else 0);
   --  The message in Line, which has no line end. Every line has a meaning, at
   --  least Malformed: an empty line, a label in lower case, data for a
   --  command that takes none, a missing or non-decimal number, a path with a
   --  point too many.

   --  Lines from the monitor

   subtype Line_Length is Natural range 0 .. Max_Line;

   type Line_Reader is private;
   --  The line being received. Initially empty.

   function Length (R : Line_Reader) return Line_Length;
   --  Characters of the line so far, or of the complete line.

   function Is_Too_Long (R : Line_Reader) return Boolean;
   --  The line has more than Max_Line characters: the rest is dropped.

   function Is_Complete (R : Line_Reader) return Boolean with Ghost;
   --  Its line feed has been received: the next character starts another line.

   function Is_Held (R : Line_Reader) return Boolean with Ghost;
   --  The last character was a carriage return; the next one decides whether
   --  it belongs to the line end.

   function Item (R : Line_Reader; I : Positive) return Character
   with Ghost, Pre => I <= Length (R);
   --  Character I of the line.

   function Kept (R : Line_Reader) return Line_Length is
     (if Is_Complete (R) then 0 else Length (R))
   with Ghost;
   --  Number of characters received of the current line.

   function Added (R : Line_Reader; C : Character) return Natural is
     ((if Is_Held (R) and then not Is_Complete (R) and then C /= Line_Feed
       then 1 else 0)
      + (if C in Carriage_Return | Line_Feed then 0 else 1))
   with Ghost;
   --  Length after C: a carriage return is held until the next character.

   function After_Telnet
     (Line : String; First : Positive; Last : Natural) return Positive
   with
     Pre  => Line'Last < Integer'Last
       and then First >= Line'First
       and then Last <= Line'Last
       and then First <= Last + 1,
     Post => After_Telnet'Result in First .. Last + 1
       and then (if First > Last or else Line (First) /= Telnet_Mark
                 then After_Telnet'Result = First);
   --  Where what follows the telnet commands at First begins. One that has not
   --  been received as a whole is none.

   function Text_First (R : Line_Reader) return Positive
   with Post => Text_First'Result <= Length (R) + 1
     and then (if Length (R) = 0 or else Item (R, 1) /= Telnet_Mark
               then Text_First'Result = 1);

   function Text_Last (R : Line_Reader) return Line_Length
   with Post => Text_Last'Result in Text_First (R) - 1 .. Length (R)
     and then (if (for all I in 1 .. Length (R) => Item (R, I) /= Telnet_Mark)
               then Text_Last'Result = Length (R));
   --  The line without the telnet commands at its beginning and its end.

   function May_Begin (R : Line_Reader; Start : Label_Text) return Boolean;
   --  The line so far is the beginning of Start and a separator, or begins
   --  with them, without telnet commands.

   type Beginning is (Undecided, Known, Unknown);
   --  Whether a client has begun with a line of this protocol.

   procedure Judge
     (R       : Line_Reader;
      Data    : String;
      Verdict : out Beginning;
      Line    : in out String;
      Last    : out Natural)
   with
     Pre  => Data'Last < Integer'Last
       and then Line'First = 1
       and then Line'Last >= Max_Line,
     Post => Last <= Max_Line;
   --  Of its first line, the beginning of which R has, and then Data: Unknown
   --  as soon as it cannot become a message, or the token. Line (1 .. Last) is
   --  as much of it as has come.

   procedure Clear (R : out Line_Reader)
   with
     Post => Length (R) = 0
       and then not Is_Too_Long (R)
       and then not Is_Complete (R)
       and then not Is_Held (R);
   --  Discards all that has been received.

   procedure Accept_Character
     (R : in out Line_Reader; C : Character; Complete : out Boolean)
   with
     Post => Complete = (C = Line_Feed)
       and then Is_Complete (R) = Complete
       and then (if not Complete then Is_Held (R) = (C = Carriage_Return))
       and then Length (R) =
         Integer'Min (Kept (R'Old) + Added (R'Old, C), Max_Line)
       and then Is_Too_Long (R) =
         ((Is_Too_Long (R'Old) and then not Is_Complete (R'Old))
          or else Kept (R'Old) + Added (R'Old, C) > Max_Line)
       and then
         (for all I in 1 .. Length (R) =>
            Item (R, I) =
              (if I <= Kept (R'Old) then Item (R'Old, I)
               elsif I < Kept (R'Old) + Added (R'Old, C)
                 or else C = Carriage_Return
               then Carriage_Return
               else C));
   --  Takes the next character. Complete: it ended a line, which Get_Line
   --  returns; the next character starts another line.

   procedure Get_Line
     (R : Line_Reader; Line : in out String; Last : out Natural)
   with
     Pre  => Line'First = 1 and then Line'Last >= Max_Line,
     Post => Last =
         (if Is_Too_Long (R) then 0 else Text_Last (R) - Text_First (R) + 1)
       and then
         (for all I in 1 .. Last =>
            Line (I) = Item (R, Text_First (R) + I - 1));
   --  The line is Line (1 .. Last), without its end, the carriage return
   --  before it, and telnet commands at its beginning or its end. A line that
   --  is too long is returned as empty, which Parse rejects as malformed.

   procedure Prove_Reading (Text : String)
   with
     Ghost,
     Pre => Text'First = 1
       and then Text'Last < Integer'Last
       and then (for all C of Text => C not in Line_Feed | Telnet_Mark);
   --  Any other characters and a line feed make one line: these characters
   --  without a final carriage return, or an empty line if there are more than
   --  Max_Line. Asserted in the body. Parse accepts any line.

   --  Answers

   type Answer_Kind is
     (Acknowledged,     --  AACK
      Not_Done,         --  ANAK: the line or the camera is not open
      Refused,          --  ACRJ: rejected by the robot
      Timed_Out,        --  ATIM: no answer of the robot, or robot lost
      Not_Understood,   --  ACER
      Battery_Empty,    --  RBLV:0
      Battery_Low,      --  RBLV:1
      Battery_Full,     --  RBLV:2
      Battery_Unknown,  --  RBLV:-1
      Standing,         --  RCST:0
      Moving);          --  RCST:1
   --  The battery levels are also sent unsolicited, and so is Timed_Out when
   --  the robot is lost.

   Max_Short : constant := 16;

   type Short_Text is record
      Data   : String (1 .. Max_Short)    := (others => ' ');
      Length : Natural range 0 .. Max_Short := 0;
   end record;
   --  The first Length characters of Data are valid.

   function Short (Text : String) return Short_Text
   with
     Pre  => Text'First = 1 and then Text'Last in 4 .. 7,
     Post => Short'Result.Length = Text'Last + 1
       and then Short'Result.Data (1 .. Text'Last) = Text
       and then Short'Result.Data (Text'Last + 1) = Line_Feed;
   --  Text and a line feed.

   function Wire_Text (Answer : Answer_Kind) return Short_Text is
     (case Answer is
         when Acknowledged    => Short ("AACK"),
         when Not_Done        => Short ("ANAK"),
         when Refused         => Short ("ACRJ"),
         when Timed_Out       => Short ("ATIM"),
         when Not_Understood  => Short ("ACER"),
         when Battery_Empty   => Short ("RBLV:0"),
         when Battery_Low     => Short ("RBLV:1"),
         when Battery_Full    => Short ("RBLV:2"),
         when Battery_Unknown => Short ("RBLV:-1"),
         when Standing        => Short ("RCST:0"),
         when Moving          => Short ("RCST:1"));
   --  The line of the answer, with its line feed.

   subtype Battery_Level is Integer range -1 .. 2;
   --  -1: unknown; 0 empty, 1 low, 2 full.

   function Battery_Answer (Level : Battery_Level) return Answer_Kind is
     (case Level is
         when -1 => Battery_Unknown,
         when 0  => Battery_Empty,
         when 1  => Battery_Low,
         when 2  => Battery_Full);

   --  Labels of unsolicited messages; separator and data follow.

   Image_Label    : constant Label_Text := "CIMG";
   Position_Label : constant Label_Text := "CPOS";
   Battery_Label  : constant Label_Text := "RBLV";
   State_Label    : constant Label_Text := "RCST";
   Progress_Label : constant Label_Text := "MPRG";
   End_Label      : constant Label_Text := "MEND";
   Log_Label      : constant Label_Text := "MSSG";

   Field_Separator : constant Character := ';';
   --  Between the fields of a message's data.

   Max_Short_Line : constant := 128;

   subtype Short_Line is String (1 .. Max_Short_Line);
   --  Room for each message without an image, with its line feed.

private

   type Line_Reader is record
      Data     : String (1 .. Max_Line) := (others => ' ');
      Length   : Line_Length            := 0;
      Held     : Boolean                := False;
      --  The last character was a carriage return; the next one decides
      --  whether it belongs to the line end.
      Too_Long : Boolean                := False;
      Finished : Boolean                := False;
   end record;

   function Length (R : Line_Reader) return Line_Length is (R.Length);

   function Is_Too_Long (R : Line_Reader) return Boolean is (R.Too_Long);

   function Is_Complete (R : Line_Reader) return Boolean is (R.Finished);

   function Is_Held (R : Line_Reader) return Boolean is (R.Held);

   function May_Begin (R : Line_Reader; Start : Label_Text) return Boolean is
     ((for all I in 1 .. Integer'Min (R.Length - Text_First (R) + 1, 4) =>
         R.Data (Text_First (R) + I - 1) = Start (I))
      and then
        (R.Length < Text_First (R) + 4
         or else R.Data (Text_First (R) + 4) in Separator | Telnet_Mark));

   function Item (R : Line_Reader; I : Positive) return Character is
     (R.Data (I));

end Monitor.Protocol;
