--  SPDX-License-Identifier: GPL-3.0-or-later
--  The protocol of the monitor: parses its lines, and formats answers.

with Commands; use Commands;
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

   package Numbers renames Monitor.Paths.Numbers;

   function Has_Data (Line : String) return Boolean is
     (Line'Length >= 5 and then Line (Line'First + 4) = Separator)
   with Pre => Line'Last < Integer'Last;
   --  The label is followed by a separator; the data may be empty.

   function Digits_First (Line : String; First : Positive) return Positive is
     (if Line (First) in '+' | '-' then First + 1 else First)
   with Pre => Line'Last < Integer'Last and then First in Line'Range;

   function Is_Number (Line : String; First : Positive) return Boolean is
     (First <= Line'Last
      and then Digits_First (Line, First) <= Line'Last
      and then Numbers.Are_Digits
        (Line, Digits_First (Line, First), Line'Last))
   with Pre => Line'Last < Integer'Last and then First >= Line'First;
   --  Decimal: an optional sign, then any number of digits. No blanks.

   function Clamped_Number (Line : String; First : Positive) return Argument is
     (if Line (First) = '-'
      then -Integer'Min
        (Numbers.Saturated_Value (Line, First + 1, Line'Last), 32_768)
      else Integer'Min
        (Numbers.Saturated_Value
           (Line, Digits_First (Line, First), Line'Last), 32_767))
   with Pre => Line'Last < Integer'Last
     and then First >= Line'First
     and then Is_Number (Line, First);
   --  The number, limited to the robot's range.

   function Is_Line_Of (Line : String; Name : Known_Command) return Boolean is
     (Line'Length >= 4
      and then Line (Line'First) = Table (Name).Label (1)
      and then Line (Line'First + 1) = Table (Name).Label (2)
      and then Line (Line'First + 2) = Table (Name).Label (3)
      and then Line (Line'First + 3) = Table (Name).Label (4)
      and then
        (case Table (Name).Data is
            when None      =>
               Line'Length = 4
               or else (Line'Length = 5 and then Has_Data (Line)),
            when Number    =>
               Has_Data (Line)
               and then Is_Number (Line, Line'First + Text_Offset),
            when Text      => Has_Data (Line),
            when Path_Data =>
               Has_Data (Line)
               and then Monitor.Paths.Is_Path
                 (Line, Line'First + Text_Offset, Most_Points (Name))))
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
          then Clamped_Number (Line, Line'First + Text_Offset)
          else 0);
   --  The command in Line, which has no line end. Every line has a meaning, at
   --  least Malformed: an empty line, a label in lower case, data for a
   --  command that takes none, a missing or non-decimal number, a path with a
   --  point too many.

   --  Lines from the monitor

   subtype Line_Buffer is String (1 .. Max_Line);

   subtype Line_Length is Natural range 0 .. Max_Line;

   type Line_Reader is record
      Data     : String (1 .. Max_Line + 1) := (others => ' ');
      Length   : Natural range 0 .. Max_Line + 1 := 0;
      --  Characters of the line so far; a carriage return may be the last
      Too_Long : Boolean := False;
      --  There was no room for more: the rest is dropped
   end record;
   --  The line being received

   procedure Accept_Character
     (R : in out Line_Reader; C : Character; Complete : out Boolean)
   with Post => Complete = (C = Line_Feed);
   --  Takes the next character. Complete: it ended the line. The next one
   --  begins with a new reader.

   procedure Get_Line
     (R : Line_Reader; Line : in out Line_Buffer; Last : out Line_Length);
   --  The line is Line (1 .. Last), without its end, the carriage return
   --  before it, and telnet commands at its beginning or its end. A line that
   --  is too long is returned as empty, which Parse rejects as malformed.

   type Beginning is (Undecided, Known, Unknown);
   --  Whether a client has begun with a line of this protocol.

   procedure Judge
     (R       : Line_Reader;
      Data    : String;
      Verdict : out Beginning;
      Line    : in out Line_Buffer;
      Last    : out Line_Length);
   --  Of its first line, the beginning of which R has, and then Data: Unknown
   --  as soon as it cannot become a message, or the token. Line (1 .. Last) is
   --  as much of it as has come.

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

   procedure Append (Line : in out Short_Text; Text : String)
   with
     Pre  => Text'Length <= Max_Short_Line - Line.Length,
     Post => Line.Length = Line.Length'Old + Text'Length;

   procedure Append_Number
     (Line  : in out Short_Text;
      N     : Numbers.Number;
      Width : Numbers.Digit_Count := 1)
   with
     Pre  => Line.Length <= Max_Short_Line - Numbers.Max_Digits,
     Post => Line.Length in Line.Length'Old + Width
                         .. Line.Length'Old + Numbers.Max_Digits
       and then
         (Line.Length = Line.Length'Old + Width
          or else N > Numbers.Largest (Line.Length - Line.Length'Old - 1));
   --  With zeros in front to Width digits.

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
