--  SPDX-License-Identifier: GPL-3.0-or-later
--  The protocol of the monitor: parses its lines, and formats answers.

with Commands; use Commands;
with Decimals;
with Monitor.Paths;

package Monitor.Protocol with SPARK_Mode is

   Max_Line : constant := 1024;
   --  Characters of a line from the monitor, without its end.

   Line_Feed : constant Character := Character'Val (10);

   Carriage_Return : constant Character := Character'Val (13);

   Telnet_Mark : constant Character := Character'Val (255);
   --  Telnet commands (RFC 854, 885, 1184) begin with it, such as those of a
   --  Ctrl-C. They are skipped where a line begins or ends, and no part of any
   --  command.

   --  Commands of the monitor

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
     return Argument
   is (if Line (First) = '-'
       then -Integer'Min (Magnitude (Line, First, Last), 32_768)
       else Integer'Min (Magnitude (Line, First, Last), 32_767))
   with Pre => Line'Last < Integer'Last
     and then First >= Line'First
     and then Last <= Line'Last
     and then Is_Number (Line, First, Last);
   --  The number, limited to the robot's range.

   function Is_Line_Of (Line : String; Name : Known_Command) return Boolean is
     (Begins_With (Line, Table (Name).Label)
      and then
        (case Table (Name).Data is
            when None      =>
               Line'Length = 4
               or else (Line'Length = 5 and then Has_Data (Line)),
            when Number    =>
               Has_Data (Line)
               and then Is_Number
                 (Line, Line'First + Text_Offset, Line'Last),
            when Text      => Has_Data (Line),
            when Path_Data =>
               Has_Data (Line)
               and then Monitor.Paths.Is_Path
                 (Line, Line'First + Text_Offset, Is_Single (Name))))
   with Pre => Line'Last < Integer'Last;
   --  The label, and the data that the command takes. The existing monitor
   --  appends a separator to every label, so a separator with nothing after it
   --  is accepted

   procedure Parse (Line : String; C : out Command)
   with
     Pre  => Line'Last < Integer'Last,
     Post =>
       (for all N in Known_Command => (C.Name = N) = Is_Line_Of (Line, N))
       and then C.Value =
         (if Takes_Number (C.Name)
          then Clamped_Number (Line, Line'First + Text_Offset, Line'Last)
          else 0);
   --  The command in Line, which has no line end. Every line has a meaning, at
   --  least Malformed: an empty line, a label in lower case, data for a
   --  command that takes none, a missing or non-decimal number, a path with a
   --  point too many.

   --  Lines from the monitor

   subtype Line_Length is Natural range 0 .. Max_Line;

   type Line_Reader is record
      Data     : String (1 .. Max_Line) := (others => ' ');
      Length   : Line_Length            := 0;
      --  Characters of the line so far, or of the complete line
      Held     : Boolean                := False;
      --  The last character was a carriage return; the next one decides
      --  whether it belongs to the line end
      Too_Long : Boolean                := False;
      --  The line has more than Max_Line characters: the rest is dropped
      Finished : Boolean                := False;
      --  Its line feed has been received: the next character starts another
   end record;
   --  The line being received

   function Kept (R : Line_Reader) return Line_Length is
     (if R.Finished then 0 else R.Length)
   with Ghost;
   --  Number of characters received of the current line.

   function Added (R : Line_Reader; C : Character) return Natural is
     ((if R.Held and then not R.Finished and then C /= Line_Feed
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
   with Post => Text_First'Result <= R.Length + 1
     and then (if R.Length = 0 or else R.Data (1) /= Telnet_Mark
               then Text_First'Result = 1);

   function Text_Last (R : Line_Reader) return Line_Length
   with Post => Text_Last'Result in Text_First (R) - 1 .. R.Length
     and then (if (for all I in 1 .. R.Length => R.Data (I) /= Telnet_Mark)
               then Text_Last'Result = R.Length);
   --  The line without the telnet commands at its beginning and its end.

   function May_Begin (R : Line_Reader; Start : Label_Text) return Boolean is
     ((for all I in 1 .. Integer'Min (R.Length - Text_First (R) + 1, 4) =>
         R.Data (Text_First (R) + I - 1) = Start (I))
      and then
        (R.Length < Text_First (R) + 4
         or else R.Data (Text_First (R) + 4) in Separator | Telnet_Mark));
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

   procedure Accept_Character
     (R : in out Line_Reader; C : Character; Complete : out Boolean)
   with
     Post => Complete = (C = Line_Feed)
       and then R.Finished = Complete
       and then (if not Complete then R.Held = (C = Carriage_Return))
       and then R.Length =
         Integer'Min (Kept (R'Old) + Added (R'Old, C), Max_Line)
       and then R.Too_Long =
         ((R'Old.Too_Long and then not R'Old.Finished)
          or else Kept (R'Old) + Added (R'Old, C) > Max_Line)
       and then
         (for all I in 1 .. R.Length =>
            R.Data (I) =
              (if I <= Kept (R'Old) then R'Old.Data (I)
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
         (if R.Too_Long then 0 else Text_Last (R) - Text_First (R) + 1)
       and then
         (for all I in 1 .. Last =>
            Line (I) = R.Data (Text_First (R) + I - 1));
   --  The line is Line (1 .. Last), without its end, the carriage return
   --  before it, and telnet commands at its beginning or its end. A line that
   --  is too long is returned as empty, which Parse rejects as malformed.

   --  Messages to the monitor

   Image_Label    : constant Label_Text := Table (Ask_Arena).Reply;
   Position_Label : constant Label_Text := "CPOS";
   Battery_Label  : constant Label_Text := Table (Get_Battery).Reply;
   Progress_Label : constant Label_Text := "MPRG";
   End_Label      : constant Label_Text := "MEND";
   Log_Label      : constant Label_Text := "MSSG";

   Field_Separator : constant Character := ';';
   --  Between the fields of a message's data.

   Max_Short_Line : constant := 128;

   subtype Short_Line is String (1 .. Max_Short_Line);
   --  Room for each message without an image, with its line feed.

   type Short_Text is record
      Data   : Short_Line := (others => ' ');
      Length : Natural range 0 .. Max_Short_Line := 0;
   end record;
   --  A message without an image, as it is sent: the first Length characters
   --  of Data.

   No_Line : constant Short_Text := (others => <>);

   function Short (Text : String) return Short_Text is
     ((Data   => Text & Line_Feed & (Text'Length + 2 .. Max_Short_Line => ' '),
       Length => Text'Length + 1))
   with
     Pre  => Text'First = 1 and then Text'Last in 1 .. Max_Short_Line - 1,
     Post => Short'Result.Length = Text'Last + 1
       and then (for all I in Text'Range => Short'Result.Data (I) = Text (I))
       and then Short'Result.Data (Text'Last + 1) = Line_Feed;
   --  Text and a line feed.

   --  Replies

   Acknowledged   : constant Short_Text := Short (Done_Label);
   Not_Done       : constant Short_Text := Short ("ANAK");
   --  The line or the camera is not open.
   Refused        : constant Short_Text := Short ("ACRJ");
   --  By the robot.
   Timed_Out      : constant Short_Text := Short ("ATIM");
   --  No answer of the robot. Also sent unsolicited: the robot is lost.
   Not_Understood : constant Short_Text := Short ("ACER");

   function Reply_To
     (Name : Command_Name; Result : Outcome) return Short_Text
   is (case Result.Kind is
          when Done      =>
            (if Table (Name).Reply = Done_Label then Acknowledged
             else Short
               (Table (Name).Reply & Separator
                & Result.Text.Data (1 .. Result.Text.Length))),
          when Commands.Refused   => Refused,
          when Commands.Timed_Out => Timed_Out,
          when Not_Open | Not_Opened => Not_Done);
   --  To a command of which the robot has made Result.

   function Reply_To (Done : Boolean) return Short_Text is
     (if Done then Acknowledged else Not_Done);
   --  To a command for the camera.

   function Battery_Notice (Result : Outcome) return Short_Text
   is (if Result.Kind = Done
       then Reply_To (Get_Battery, Result) else Short (Battery_Label & ":-1"));
   --  The battery's level, unsolicited; -1: unknown.

end Monitor.Protocol;
