--  SPDX-License-Identifier: GPL-3.0-or-later
--  The protocol of the monitor: parses its lines, and formats answers.

with Commands; use Commands;
with Decimals;
with Missions; use Missions;

package Monitor.Protocol with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Monitor.Protocol);  --  proved

   pragma Assertion_Policy (Subprogram_Variant => Ignore);
   --  Proved; GNAT 12 cannot compile the run-time check.

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

   Field_Separator : constant Character := ';';
   --  Between the fields of a line's data, such as the coordinates of a path.

   Text_Offset : constant := 5;
   --  The text of a Log_Message is Line (Line'First + Text_Offset ..
   --  Line'Last); it may be empty. The path of a mission begins there, too.

   package Numbers is new Decimals (Character, String);

   function Is_Slice
     (Line : String; First : Positive; Last : Integer) return Boolean is
     (Line'Last < Integer'Last
      and then First >= Line'First
      and then Last <= Line'Last
      and then First <= Last + 1);
   --  Line (First .. Last) is a part of Line, perhaps empty

   --  A coordinate of a path: an optional minus sign, one to seven digits,
   --  then nothing, or a point and one to six digits

   function Place_Of
     (Mark : Character; Line : String; First : Positive; Last : Natural)
      return Positive
   with
     Pre  => Is_Slice (Line, First, Last),
     Post => Place_Of'Result in First .. Last + 1
       and then (for all I in First .. Place_Of'Result - 1 => Line (I) /= Mark)
       and then (if Place_Of'Result <= Last then
                    Line (Place_Of'Result) = Mark);
   --  The first place of Mark in Line (First .. Last); Last + 1: there is none

   function Are_Digits
     (Line : String; First : Positive; Last : Natural; Most : Positive)
      return Boolean
   is (Last >= First
       and then Last - First < Most
       and then Numbers.Are_Digits (Line, First, Last))
   with Pre => Is_Slice (Line, First, Last);

   function Is_Size
     (Line : String; First : Positive; Last : Natural) return Boolean
   is (Are_Digits (Line, First, Place_Of ('.', Line, First, Last) - 1, 7)
       and then
         (Place_Of ('.', Line, First, Last) > Last
          or else Are_Digits
            (Line, Place_Of ('.', Line, First, Last) + 1, Last, 6)))
   with Pre => Is_Slice (Line, First, Last);

   subtype Fraction_Digits is Positive range 1 .. 6;

   function Scale (Count : Fraction_Digits) return Millionths is
     (if Count = 6 then 1 else Millionths (Numbers.Largest (6 - Count)) + 1);
   --  Millionths in a unit of the last of Count digits after the point

   function Size_Value
     (Line : String; First : Positive; Last : Natural) return Millionths
   is (Millionths
         (Numbers.Value (Line, First, Place_Of ('.', Line, First, Last) - 1))
       * 1_000_000
       + (if Place_Of ('.', Line, First, Last) > Last then 0
          else Millionths
            (Numbers.Value (Line, Place_Of ('.', Line, First, Last) + 1, Last))
            * Scale (Last - Place_Of ('.', Line, First, Last))))
   with
     Pre  => Is_Slice (Line, First, Last) and then Is_Size (Line, First, Last),
     Post => Size_Value'Result >= 0;

   function Is_Coordinate
     (Line : String; First : Positive; Last : Natural) return Boolean
   is (First <= Last
       and then Is_Size
         (Line, (if Line (First) = '-' then First + 1 else First), Last))
   with Pre => Is_Slice (Line, First, Last);

   function Coordinate_Value
     (Line : String; First : Positive; Last : Natural) return Millionths
   is (if Line (First) = '-' then -Size_Value (Line, First + 1, Last)
       else Size_Value (Line, First, Last))
   with Pre => Is_Slice (Line, First, Last)
     and then Is_Coordinate (Line, First, Last);

   --  A path: points of two coordinates each

   function Field_End (Line : String; First : Positive) return Natural is
     (Place_Of (Field_Separator, Line, First, Line'Last) - 1)
   with Pre => Is_Slice (Line, First, Line'Last);

   function Are_Points
     (Line : String; First : Positive; Most : Natural) return Boolean
   is (Most > 0
       and then Is_Coordinate (Line, First, Field_End (Line, First))
       and then
         (if Field_End (Line, First) = Line'Last then Most mod 2 = 1
          else Are_Points (Line, Field_End (Line, First) + 2, Most - 1)))
   with
     Pre => Is_Slice (Line, First, Line'Last),
     Subprogram_Variant => (Decreases => Most);
   --  Line (First .. Line'Last) is Most coordinates at most, and the last is
   --  the second of a point

   function Is_Path
     (Line : String; First : Positive; Most : Point_Number) return Boolean
   is (Are_Points (Line, First, 2 * Most))
   with Pre => Is_Slice (Line, First, Line'Last);
   --  Line (First .. Line'Last) is 1 to Most points

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
               and then Is_Path
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

   procedure Parse
     (Line    : String;
      First   : Positive;
      Measure : Unit;
      Most    : Point_Number;
      P       : out Path;
      Valid   : out Boolean)
   with
     Pre  => Is_Slice (Line, First, Line'Last),
     Post => Valid = Is_Path (Line, First, Most)
       and then P.Measure = Measure
       and then (if Valid then P.Count in 1 .. Most else P.Count = 0);
   --  The points in Line (First .. Line'Last)

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

   Max_Short_Line : constant := 128;
   --  Room for each message without an image, with its line feed.

   type Short_Text is record
      Data   : String (1 .. Max_Short_Line) := (others => ' ');
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
