--  SPDX-License-Identifier: GPL-3.0-or-later
--  The monitor's lines: every label, numbers, line ends, answers, positions.

with Ada.Numerics.Discrete_Random;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;

with AUnit.Assertions; use AUnit.Assertions;

with Commands; use Commands;
with Missions;
with Monitor.Positions; use Monitor.Positions;
with Monitor.Protocol;  use Monitor.Protocol;
with Position_Lines;
with Robot.Protocol;
with Robot.Session;
with Unit_Runs; use Unit_Runs;

package body Monitor_Protocol_Tests is

   LF : Character renames Line_Feed;
   CR : Character renames Carriage_Return;

   package Random_Characters is
     new Ada.Numerics.Discrete_Random (Character);

   package Random_Micros is new Ada.Numerics.Discrete_Random (Micro);

   package Random_Ids is new Ada.Numerics.Discrete_Random (Robot_Id);

   function Label (Name : Command_Name) return Label_Text is
     (Table (Name).Label);

   function Parsed (Line : String) return Command is
      C : Command;
   begin
      Parse (Line, C);
      return C;
   end Parsed;

   procedure Feed (R : in out Line_Reader; Text : String) is
      --  None of Text ends a line.
      Complete : Boolean;
   begin
      for C of Text loop
         Accept_Character (R, C, Complete);
         Assert (not Complete, "no end of line");
      end loop;
   end Feed;

   function Formatted (P : Position) return String is
      --  Without the line feed, which is checked.
      Buffer : Short_Line;
      Last   : Natural;
   begin
      Format (P, Buffer, Last);
      Assert (Buffer (Last) = LF, "line feed");
      return Buffer (1 .. Last - 1);
   end Formatted;

   function Image (Value : Micro) return String is
      --  Six decimals, by other means than the package's.
      Digits_Only : constant String :=
        Ada.Strings.Fixed.Trim
          (Long_Long_Integer'Image (Long_Long_Integer (abs Value)),
           Ada.Strings.Left);
      Filled : constant String :=
        (if Digits_Only'Length >= 7 then Digits_Only
         else Ada.Strings.Fixed.Tail (Digits_Only, 7, '0'));
   begin
      return (if Value < 0 then "-" else "")
        & Filled (Filled'First .. Filled'Last - 6) & "."
        & Filled (Filled'Last - 5 .. Filled'Last);
   end Image;

   procedure Check_Line (R : in out Line_Reader; Text, Expected : String) is
      --  The last character of Text, and only that, ends a line: Expected.
      Line     : String (1 .. Max_Line + 10) := (others => '.');
      Last     : Natural;
      Complete : Boolean;
   begin
      Feed (R, Text (Text'First .. Text'Last - 1));
      Accept_Character (R, Text (Text'Last), Complete);
      Assert (Complete, "complete: " & Expected);
      Get_Line (R, Line, Last);
      Assert (not Is_Too_Long (R), "not too long: " & Expected);
      Assert (Line (1 .. Last) = Expected, "line " & Expected);
      Assert (Length (R) = Expected'Length, "length of " & Expected);
      Assert ((for all I in Last + 1 .. Line'Last => Line (I) = '.'),
              "behind " & Expected);
   end Check_Line;

   procedure Check_Malformed (Line : String) is
   begin
      Assert (Parsed (Line) = (Malformed, 0), "malformed: " & Line);
   end Check_Malformed;

   procedure Check_Position (P : Position) is
      --  Formatted as expected, and read back.
      Text : constant String := Formatted (P);
      Q    : Position;
      OK   : Boolean;
   begin
      Assert (Text = "CPOS:" & Ada.Strings.Fixed.Trim
                (Integer'Image (P.Id), Ada.Strings.Left)
              & ";" & Image (P.Angle) & ";" & Image (P.Cx) & ";"
              & Image (P.Cy) & ";" & Image (P.Dx) & ";" & Image (P.Dy),
              "text " & Text);
      Position_Lines.Parse (Text, Q, OK);
      Assert (OK and then Q = P, "read back " & Text);
   end Check_Position;

   procedure Check_Refused_Position (Line : String) is
      P  : Position;
      OK : Boolean;
   begin
      Position_Lines.Parse (Line, P, OK);
      Assert (not OK and then P = Not_Found, "no position: " & Line);
   end Check_Refused_Position;

   procedure Test_Answered is
   begin
      for K in Command_Name loop
         Assert (Is_Answered (K)
                   = (K /= Confirm_Arena and then K /= Reject_Arena
                      and then K not in Sign_Of_Life | Log_Message),
                 K'Image);
      end loop;
   end Test_Answered;

   procedure Test_Answers is

      procedure Check (Line : Short_Text; Text : String) is
         --  Line is Text and a line feed.
      begin
         Assert (Line.Data (1 .. Line.Length) = Text & LF, Text);
      end Check;

      function Said (Text : String) return Robot.Session.Outcome is
        ((Text   => (Data   => Ada.Strings.Fixed.Head
                       (Text, Robot.Protocol.Text_Size'Last),
                     Length => Text'Length),
          others => <>));
      --  The robot has answered with Text

   begin
      Check (Acknowledged, "AACK");
      Check (Not_Done, "ANAK");
      Check (Refused, "ACRJ");
      Check (Timed_Out, "ATIM");
      Check (Not_Understood, "ACER");
      Check (Reply_To (Get_Battery, Said ("2")), "RBLV:2");
      Check (Reply_To (Get_State, Said ("1")), "RCST:1");
      Check (Reply_To (Get_Version, Said ("3.5")), "RVER:3.5");
      Check (Reply_To (Ping_Robot, Said ("O")), "AACK");
      Check (Battery_Notice (Said ("0")), "RBLV:0");
      Check
        (Battery_Notice ((Kind => Robot.Session.Timed_Out, others => <>)),
         "RBLV:-1");
   end Test_Answers;

   procedure Test_Any_Label is
      Line  : String (1 .. 4);
      Known : Boolean;
   begin
      for K in Known_Command loop
         for Place in 1 .. 4 loop
            for C in Character loop
               Line := Label (K);
               Line (Place) := C;
               Known := (for some J in Known_Command => Line = Label (J));
               if not Known then
                  Check_Malformed (Line);
                  Check_Malformed (Line & ":");
                  Check_Malformed (Line & ":1");
               end if;
            end loop;
         end loop;
      end loop;
   end Test_Any_Label;

   procedure Test_Bad_Numbers is

      procedure Check (Data : String) is
         --  Neither order takes Data.
      begin
         Check_Malformed ("RMOV" & Data);
         Check_Malformed ("RTRN" & Data);
      end Check;

   begin
      Check ("");
      Check (":");
      Check (":-");
      Check (":+");
      Check (":--1");
      Check (":+-1");
      Check (":1-");
      Check (": 1");
      Check (":1 ");
      Check (":1 2");
      Check (":1.5");
      Check (":1e3");
      Check (":0x10");
      Check (":1_000");
      Check (":one");
      Check (":12:3");
      Check ("::12");
      Check ("12");
      Check ("=12");
      Check (":" & (1 .. 1000 => '9') & "x");
      Check (":" & (1 .. 1000 => '0') & "-");
      for C in Character loop
         if C not in '0' .. '9' then
            Check (":" & C);
            Check (":1" & C);
            Check (":-" & C);
            if C not in '+' | '-' then
               Check (":" & C & "1");
            end if;
            Check (":123456789" & C & "12345678");
         end if;
      end loop;
   end Test_Bad_Numbers;

   procedure Test_Beginnings is
      --  Every part of a message may become one, and nothing else
      R        : Line_Reader;
      Complete : Boolean;
      Verdict  : Beginning;
      Line     : String (1 .. Max_Line);
      Last     : Natural;

      procedure Check (All_Of_It : String; Expected : Beginning) is
         --  Whole, and cut in two anywhere
         Text : constant String (1 .. All_Of_It'Length) := All_Of_It;
      begin
         for Cut in 0 .. Text'Length loop
            Clear (R);
            Judge (R, Text (1 .. Cut), Verdict, Line, Last);
            Assert
              (Verdict in Undecided | Expected
               and then Last <= Cut
               and then Line (1 .. Last) = Text (1 .. Last),
               "the beginning of " & Text);
            if Verdict = Undecided then
               for C of Text (1 .. Cut) loop
                  Accept_Character (R, C, Complete);
               end loop;
               Judge
                 (R, Text (Cut + 1 .. Text'Last), Verdict, Line, Last);
               Assert (Verdict = Expected, Text);
            end if;
         end loop;
      end Check;

   begin
      for K in Known_Command loop
         Check (Label (K), Undecided);
         Check (Label (K) & ASCII.CR, Undecided);
         Check (Label (K) & ":any data", Undecided);
         Check (Label (K) & " ", Unknown);
         Check (Label (K) & ASCII.CR & ":", Unknown);
      end loop;
      Check ("RPIN" & LF & "what", Known);
      Check ("RMOV:12" & ASCII.CR & LF, Known);
      Check ("RMOV:x" & LF, Unknown);
      Check ("AUTH:token", Undecided);
      Check ("AUTH:token" & LF, Known);
      Check ("" & LF, Unknown);
      Check ("X", Unknown);
      Check ("POST / HTTP/1.1", Unknown);
      Check ("ropn" & LF, Unknown);
      Check ((1 => ASCII.NUL), Unknown);
   end Test_Beginnings;

   procedure Test_Bare is
   begin
      for K in Known_Command loop
         if Table (K).Data = None then
            Assert (Parsed (Label (K)) = (K, 0), Label (K));

            --  The existing monitor writes the separator nevertheless

            Assert (Parsed (Label (K) & ":") = (K, 0), Label (K) & ":");
            Check_Malformed (Label (K) & ":1");
            Check_Malformed (Label (K) & "::");
            Check_Malformed (Label (K) & ": ");
            Check_Malformed (Label (K) & " ");
            Check_Malformed (Label (K) & "S");
            Check_Malformed (" " & Label (K));
            Check_Malformed (Label (K) & CR);
            Check_Malformed (Label (K) & Label (K));
         end if;
      end loop;
      Check_Malformed ("");
      Check_Malformed (":");
      Check_Malformed ("R");
      Check_Malformed ("ROP");
      Check_Malformed ("ROP:");
      Check_Malformed ("ropn");
      Check_Malformed ("Ropn");
      Check_Malformed ("AACK");
      Check_Malformed ("CPOS");
      Check_Malformed ("CIMG:");
      Check_Malformed ("RBLV:1");
   end Test_Bare;

   procedure Test_Damaged_Positions is
      Text : constant String :=
        Formatted ((42, 90_000_000, 320_500_000, -1, 320_500_000, 12));
      Line : String (1 .. Text'Length);
      P    : Position;
      OK   : Boolean;
   begin
      --  Whatever one character is replaced by: refused, or another
      --  position that is written just so, but for zeros in front

      for I in Line'Range loop
         for C in Character loop
            Line := Text;
            Line (I) := C;
            Position_Lines.Parse (Line, P, OK);
            if OK and then C not in '0' | '-' then
               Assert (Formatted (P) = Line, "another position");
            end if;
         end loop;
         if I < Line'Last then
            Position_Lines.Parse (Text (1 .. I), P, OK);
            Assert (not OK, "cut");
         end if;
      end loop;
   end Test_Damaged_Positions;

   procedure Test_Every_Number is
   begin
      for N in -70_000 .. 70_000 loop
         Assert (Parsed ("RMOV:" & Ada.Strings.Fixed.Trim
                           (N'Image, Ada.Strings.Left))
                 = (Move_Robot,
                    Integer'Max (-32_768, Integer'Min (32_767, N))),
                 "move" & N'Image);
      end loop;
   end Test_Every_Number;

   procedure Test_Labels is

      Count : Natural := 0;

      procedure Check (Text : String; Kind : Known_Command) is
         --  Text is the label of Kind.
      begin
         Count := Count + 1;
         Assert (Label (Kind) = Text, "label " & Text);
         Assert ((for all K in Known_Command =>
                    K = Kind or else Label (K) /= Text), "once " & Text);
      end Check;

      procedure Check_Unsolicited (Actual, Expected : String) is
         --  The label of an unsolicited message.
      begin
         Assert (Actual = Expected, "label " & Expected);
      end Check_Unsolicited;

   begin
      Check ("ROPN", Open_Robot);
      Check ("RCLS", Close_Robot);
      Check ("RSOW", Start_Robot);
      Check ("RSWW", Start_Robot_Watchdog);
      Check ("RRST", Reset_Robot);
      Check ("RPIN", Ping_Robot);
      Check ("RLDW", Reload_Watchdog);
      Check ("RGFW", Go_Forward);
      Check ("RGBW", Go_Backward);
      Check ("RGLF", Go_Left);
      Check ("RGRI", Go_Right);
      Check ("RSTP", Stop_Robot);
      Check ("MABT", Abort_Mission);
      Check ("RMOV", Move_Robot);
      Check ("RTRN", Turn_Robot);
      Check ("RPOF", Power_Off_Robot);
      Check ("RGBT", Get_Battery);
      Check ("RVER", Get_Version);
      Check ("RGST", Get_State);
      Check ("COPN", Open_Camera);
      Check ("CCLS", Close_Camera);
      Check ("CASA", Ask_Arena);
      Check ("CACO", Confirm_Arena);
      Check ("CAIN", Reject_Arena);
      Check ("CARN", Get_Ground);
      Check ("CPCO", Start_Position);
      Check ("CPST", Stop_Position);
      Check ("MGTO", Go_To_Pixels);
      Check ("MPTH", Follow_Pixels);
      Check ("MGCM", Go_To_Centimetres);
      Check ("MPCM", Follow_Centimetres);
      Check ("LIVE", Sign_Of_Life);
      Check ("MSSG", Log_Message);
      Assert
        (Count = Known_Command'Pos (Known_Command'Last) + 1, "all of them");
      Check_Unsolicited (Image_Label, "CIMG");
      Check_Unsolicited (Position_Label, "CPOS");
      Check_Unsolicited (Battery_Label, "RBLV");
      Check_Unsolicited (Progress_Label, "MPRG");
      Check_Unsolicited (End_Label, "MEND");
      Check_Unsolicited (Log_Label, "MSSG");
   end Test_Labels;

   procedure Test_Line_Ends is
      R : Line_Reader;
   begin
      Check_Line (R, "ROPN" & LF, "ROPN");
      Check_Line (R, "ROPN" & CR & LF, "ROPN");
      Check_Line (R, (1 => LF), "");
      Check_Line (R, CR & LF, "");
      Check_Line (R, CR & CR & LF, (1 => CR));
      Check_Line (R, CR & "RPIN" & LF, CR & "RPIN");
      Check_Line (R, "RP" & CR & "IN" & CR & LF, "RP" & CR & "IN");
      Check_Line (R, "RP" & CR & CR & "IN" & LF, "RP" & CR & CR & "IN");
      Check_Line (R, "RMOV:-12" & LF, "RMOV:-12");

      --  Half a line, then another connection

      Feed (R, "RSWW");
      Assert (Length (R) = 4, "half a line");
      Clear (R);
      Assert (Length (R) = 0, "cleared");
      Check_Line (R, "CASA" & LF, "CASA");
      Feed (R, "RSWW" & CR);
      Clear (R);
      Check_Line (R, "CASA" & LF, "CASA");
   end Test_Line_Ends;

   procedure Test_Log is
      Line : constant String := "MSSG:hello: world";
   begin
      Assert (Parsed (Line) = (Log_Message, 0), "text");
      Assert (Line (Line'First + Text_Offset .. Line'Last)
                = "hello: world", "where it is");
      Assert (Parsed ("MSSG:") = (Log_Message, 0), "empty text");
      Assert (Parsed ("MSSG:1") = (Log_Message, 0), "digits");
      for C in Character loop
         Assert (Parsed ("MSSG:" & C) = (Log_Message, 0), "any text");
      end loop;
      Check_Malformed ("MSSG");
      Check_Malformed ("MSSG hello");
      Check_Malformed ("mssg:hello");
   end Test_Log;

   procedure Test_Long_Lines is
      R        : Line_Reader;
      Full     : constant String (1 .. Max_Line) := (others => 'x');
      Line     : String (1 .. Max_Line) := (others => '.');
      Last     : Natural;
      Complete : Boolean;
   begin
      Check_Line (R, Full & LF, Full);
      Check_Line (R, Full & CR & LF, Full);
      for Extra in 1 .. 20 loop
         Feed (R, Full);
         Assert (not Is_Too_Long (R), "full");
         for I in 1 .. Extra ** 3 loop
            Feed (R, "y");
            Assert (Is_Too_Long (R), "too long");
         end loop;
         if Extra mod 2 = 0 then
            Feed (R, (1 => CR));
         end if;
         Accept_Character (R, LF, Complete);
         Get_Line (R, Line, Last);
         Assert (Complete and then Is_Too_Long (R) and then Last = 0,
                 "given as an empty line");
         Check_Malformed (Line (1 .. Last));
         if Extra mod 3 = 0 then
            Check_Line (R, "RSTP" & LF, "RSTP");
         end if;
      end loop;

      --  A carriage return that does not end the line counts

      Feed (R, Full & CR);
      Assert (not Is_Too_Long (R), "it may be the end");
      Feed (R, "z");
      Assert (Is_Too_Long (R), "it was not");
   end Test_Long_Lines;

   procedure Test_Missions is

      type Units is array (Mission_Command) of Missions.Unit;

      Expected : constant Units :=
        (Go_To_Pixels | Follow_Pixels => Missions.Pixels,
         others                       => Missions.Centimetres);

      use type Missions.Unit;
   begin
      for K in Mission_Command loop
         Assert (Is_Answered (K), "answered");
         Assert (Measure (K) = Expected (K), "the unit of " & Label (K));
         Assert (Is_Single (K) = (Label (K) in "MGTO" | "MGCM"), "single");
         Assert (Parsed (Label (K) & ":320.5;-12") = (K, 0), "a point");
         Assert
           (Parsed (Label (K) & ":1;2;3;4").Name =
              (if Is_Single (K) then Malformed else K), "two points");
         Check_Malformed (Label (K));
         Check_Malformed (Label (K) & ":");
         Check_Malformed (Label (K) & ":1");
         Check_Malformed (Label (K) & ":1;");
         Check_Malformed (Label (K) & ":1;2;");
         Check_Malformed (Label (K) & ":1;2;3");
         Check_Malformed (Label (K) & ": 1;2");
         Check_Malformed (Label (K) & " 1;2");
         Check_Malformed (Label (K) & ":+1;2");
         Check_Malformed (Label (K) & ":1;2" & CR);
         Check_Malformed (Label (K) & ":12345678;2");
         Check_Malformed (Label (K) & ":1.1234567;2");
      end loop;
   end Test_Missions;

   procedure Test_Not_Found is
   begin
      Assert (Formatted (Not_Found) =
              "CPOS:-1;0.000000;-1.000000;-1.000000;0.000000;0.000000",
              "identifier -1, centre (-1, -1)");
      Check_Position (Not_Found);
   end Test_Not_Found;

   procedure Test_Numbers is

      procedure Check (Data : String; Value : Integer) is
         --  Both orders take Data as Value.
      begin
         Assert (Parsed ("RMOV:" & Data) = (Move_Robot, Value), Data);
         Assert (Parsed ("RTRN:" & Data) = (Turn_Robot, Value), Data);
      end Check;

   begin
      Check ("0", 0);
      Check ("-0", 0);
      Check ("+0", 0);
      Check ("7", 7);
      Check ("+7", 7);
      Check ("-7", -7);
      Check ("007", 7);
      Check ("-007", -7);
      Check ("32767", 32_767);
      Check ("32768", 32_767);
      Check ("-32768", -32_768);
      Check ("-32769", -32_768);
      Check ("99999999", 32_767);
      Check ("100000000", 32_767);
      Check ("-100000000", -32_768);
      Check ("2147483648", 32_767);
      Check ("4294967297", 32_767);
      Check ("-4294967297", -32_768);
      Check ("18446744073709551617", 32_767);
      Check ((1 .. 1019 => '9'), 32_767);
      Check ("-" & (1 .. 1018 => '9'), -32_768);
      Check ((1 .. 1018 => '0') & "5", 5);
      Check ("-" & (1 .. 1000 => '0') & "32768", -32_768);
   end Test_Numbers;

   procedure Test_Parse_Chaos is
      G    : Random_Characters.Generator;
      Line : String (1 .. 40);
      Size : Natural;
      C    : Command;
      Seen : array (Command_Name) of Natural := (others => 0);
      Few  : constant String := "RMOVTN:-0123456789+";
   begin
      Random_Characters.Reset (G, 7);
      for Round in 1 .. 100_000 loop
         Size := Character'Pos (Random_Characters.Random (G)) mod 41;
         for I in 1 .. Size loop
            Line (I) := Random_Characters.Random (G);
            if Round mod 2 = 0 then
               Line (I) :=
                 Few (1 + Character'Pos (Line (I)) mod Few'Length);
            end if;
         end loop;
         if Round mod 3 = 0 and then Size >= 5 then
            Line (1 .. 4) := Label
              (Known_Command'Val
                 (Round / 6 mod (Known_Command'Pos (Log_Message) + 1)));
            Line (5) := ':';
         end if;
         Parse (Line (1 .. Size), C);
         Seen (C.Name) := Seen (C.Name) + 1;
         Assert (C.Name = Malformed
                 or else Line (1 .. 4) = Label (C.Name), "its label");
      end loop;
      Assert (Seen (Malformed) > 0 and then Seen (Log_Message) > 0
              and then Seen (Move_Robot) > 0 and then Seen (Stop_Robot) > 0,
              "kinds seen");
   end Test_Parse_Chaos;

   procedure Test_Parse_Slices is
      Buffer : constant String (101 .. 120) := "RSTPRTRN:-9012RMOV:5";
      High   : constant String (Integer'Last - 6 .. Integer'Last - 1) :=
        "RMOV:8";
   begin
      Assert (Parsed (Buffer (101 .. 104)) = (Stop_Robot, 0), "first");
      Assert (Parsed (Buffer (105 .. 114)) = (Turn_Robot, -9012), "second");
      Assert (Parsed (Buffer (115 .. 120)) = (Move_Robot, 5), "third");
      Assert (Parsed (Buffer (115 .. 119)) = (Malformed, 0), "cut");
      Assert (Parsed (Buffer (120 .. 119)) = (Malformed, 0), "empty");
      Assert (Parsed (High) = (Move_Robot, 8), "high");
   end Test_Parse_Slices;

   procedure Test_Positions is
      Edge : constant array (1 .. 22) of Micro :=
        (0, 1, -1, 9, -9, 10, 99_999, -99_999, 100_000, 500_000, -500_000,
         999_999, -999_999, 1_000_000, -1_000_000, 1_000_001, -1_000_001,
         180_000_000, -179_999_999, Micro'First, Micro'Last,
         Micro'Last - 1);
   begin
      Assert (Formatted ((7, 90_000_000, 320_500_000, 240_250_001,
                          320_000_000, -400_000))
              = "CPOS:7;90.000000;320.500000;240.250001;320.000000"
              & ";-0.400000", "an example");
      for Id in Robot_Id loop
         Check_Position ((Id, 0, 0, 0, 0, 0));
      end loop;
      for E of Edge loop
         Check_Position ((0, E, E, E, E, E));
         for F of Edge loop
            Check_Position ((999, E, F, E, F, E));
            Check_Position ((-1, F, F, E, E, F));
         end loop;
      end loop;
      Assert (Formatted ((999, Micro'First, Micro'First, Micro'First,
                          Micro'First, Micro'First))'Length = 93,
              "the longest");
   end Test_Positions;

   procedure Test_Ground is

      procedure Check (Actual : Short_Text; Expected : String) is
      begin
         Assert
           (Actual.Data (1 .. Actual.Length) = Expected & Line_Feed,
            Actual.Data (1 .. Actual.Length));
      end Check;

   begin
      Check
        (Ground
           ((80, 60), 8,
            (100_000_000, 50_500_000, 540_000_001, -400_000,
             600_000_000, 420_000_000, 40_000_000, 400_000_000)),
         "CARN:80;60;8;100.000000;50.500000;540.000001;-0.400000;600.000000"
         & ";420.000000;40.000000;400.000000");
      Check
        (Ground ((1_000, 1_000), 9, (others => Coordinate'Last)),
         "CARN:1000;1000;9" & 8 * ";9999.999999");
      Check
        (Ground ((30, 30), 0, (others => Coordinate'First)),
         "CARN:30;30;0" & 8 * ";-999.999999");
   end Test_Ground;

   procedure Test_Random_Positions is
      G     : Random_Micros.Generator;
      Ids   : Random_Ids.Generator;
      Scale : Micro := 1;

      function Any return Micro is (Random_Micros.Random (G) / Scale);

   begin
      Random_Micros.Reset (G, 8);
      Random_Ids.Reset (Ids, 9);
      for Round in 1 .. 30_000 loop
         Scale := (if Round mod 13 = 0 then 1 else Scale * 10);
         Check_Position
           ((Random_Ids.Random (Ids), Any, Any, Any, Any, Any));
         if Scale > 10 ** 11 then
            Scale := 1;
         end if;
      end loop;
   end Test_Random_Positions;

   procedure Test_Telnet is
      --  Its commands are skipped at both ends of a line, and nowhere else

      function Octets (Text : String) return String is
        (if Text = "" then ""
         else Character'Val (Integer'Value ("16#" & Text (Text'First) &
                Text (Text'First + 1) & "#"))
           & Octets (Text (Integer'Min (Text'First + 3, Text'Last + 1)
                           .. Text'Last)));
      --  "FF F4"

      Ctrl_C : constant String := Octets ("FF F4 FF FD 06");

      procedure Check (Sent, Expected : String) is
         R        : Line_Reader;
         Line     : String (1 .. Max_Line);
         Last     : Natural;
         Complete : Boolean;
      begin
         for C of String'(Sent & LF) loop
            Accept_Character (R, C, Complete);
         end loop;
         Get_Line (R, Line, Last);
         Assert (Line (1 .. Last) = Expected, "not " & Expected);
      end Check;

      procedure Check_Skipped (Command : String) is
         R       : Line_Reader;
         Verdict : Beginning;
         Line    : String (1 .. Max_Line);
         Last    : Natural;
         Text    : constant String := Command & "RSTP" & Command & LF;
      begin
         Check (Command, "");
         Check (Command & "RSTP", "RSTP");
         Check ("RSTP" & Command, "RSTP");
         Check (Command & "RSTP" & Command & CR, "RSTP");
         Check ("RS" & Command & "TP", "RS" & Command & "TP");
         for Cut in Text'Range loop
            Judge (R, Text (1 .. Cut), Verdict, Line, Last);
            Assert
              (Verdict = (if Cut = Text'Last then Known else Undecided),
               "a first line");
         end loop;
      end Check_Skipped;

   begin
      Check_Skipped (Ctrl_C);
      Check_Skipped (Octets ("FF FB 01 FF FD 03"));
      Check_Skipped (Octets ("FF FA 1F 00 50 FF FF F0 FF F0"));
      Check_Skipped (Octets ("FF FF"));
      Check_Skipped (Octets ("FF EC FF ED FF EE FF EF"));
      for Part of String'(Octets ("FF FD FB FA F0 41 EB")) loop
         --  a part of one is none
         Check (Telnet_Mark & "RSTP" & Part, Telnet_Mark & "RSTP" & Part);
         if Part /= Character'Val (16#F0#) then
            Check (Telnet_Mark & Part, (if Part = Telnet_Mark then ""
                                        else Telnet_Mark & Part));
         end if;
      end loop;
      Check ("RSTP" & Telnet_Mark, "RSTP" & Telnet_Mark);
      Check (Octets ("FF FA") & "RSTP", Octets ("FF FA") & "RSTP");
   end Test_Telnet;

   procedure Test_Reader_Chaos is
      G        : Random_Characters.Generator;
      R        : Line_Reader;
      Kept     : String (1 .. 4000) := (others => ' ');
      Count    : Natural := 0;
      Line     : String (1 .. Max_Line);
      Last     : Natural;
      Complete : Boolean;
      C        : Character;
      Lines    : Natural := 0;
   begin
      Random_Characters.Reset (G, 10);
      for Round in 1 .. 400_000 loop
         C := Random_Characters.Random (G);
         if C < Character'Val (16) and then Round / 100_000 mod 2 = 0 then
            C := (if C < Character'Val (8) then CR else LF);
         end if;
         if Count = Kept'Last then
            C := LF;
         elsif C = Telnet_Mark then
            C := 'x';
         end if;
         Accept_Character (R, C, Complete);
         Assert (Complete = (C = LF), "ends at the line feed");
         if Complete then
            Lines := Lines + 1;
            if Count > 0 and then Kept (Count) = CR then
               Count := Count - 1;
            end if;
            Get_Line (R, Line, Last);
            Assert (Is_Too_Long (R) = (Count > Max_Line), "too long");
            Assert (Last = (if Count > Max_Line then 0 else Count)
                    and then Line (1 .. Last) = Kept (1 .. Last),
                    "characters as they came");
            Count := 0;
         else
            Count := Count + 1;
            Kept (Count) := C;
         end if;
      end loop;
      Assert (Lines > 1_000, "lines");
   end Test_Reader_Chaos;

   procedure Test_Refused_Positions is

      Zero : constant String := "0.000000";
      Four : constant String := Zero & ";" & Zero & ";" & Zero & ";" & Zero;

      procedure Check_Field (Field : String) is
         --  No position has this for its angle, or for its last field.
      begin
         Check_Refused_Position ("CPOS:1;" & Field & ";" & Four);
         Check_Refused_Position ("CPOS:1;" & Four & ";" & Field);
      end Check_Field;

      P  : Position;
      OK : Boolean;
   begin
      Check_Refused_Position ("");
      Check_Refused_Position ("CPOS");
      Check_Refused_Position ("CPOS:");
      Check_Refused_Position ("CPOS:1");
      Check_Refused_Position ("CPOS:;;;;;");
      Check_Refused_Position ("CPOS:1;" & Four);
      Check_Refused_Position ("CPOS:1;" & Four & ";");
      Check_Refused_Position ("CPOS:1;" & Four & ";" & Zero & ";");
      Check_Refused_Position ("CPOS:1;" & Four & ";" & Zero & ";" & Zero);
      Check_Refused_Position ("CIMG:1;" & Four & ";" & Zero);
      Check_Refused_Position ("CPOS;1;" & Four & ";" & Zero);
      Check_Refused_Position ("CPOS:;" & Four & ";" & Zero);
      Check_Refused_Position ("CPOS:-;" & Four & ";" & Zero);
      Check_Refused_Position ("CPOS:-2;" & Four & ";" & Zero);
      Check_Refused_Position ("CPOS:1000;" & Four & ";" & Zero);
      Check_Refused_Position ("CPOS: 1;" & Four & ";" & Zero);
      Check_Refused_Position ("CPOS:1;" & Four & ";" & Zero & LF);

      Check_Field ("");
      Check_Field ("0");
      Check_Field ("-");
      Check_Field (".000000");
      Check_Field ("-.000000");
      Check_Field ("0.00000");
      Check_Field ("0.0000000");
      Check_Field ("0,000000");
      Check_Field ("+0.000000");
      Check_Field ("--1.000000");
      Check_Field ("1e.000000");
      Check_Field ("nan");
      Check_Field ("10000000.000001");
      Check_Field ("-10000000.000001");
      Check_Field ("100000000.000000");

      --  Zeros in front and a negative zero do no harm

      declare
         Line : constant String :=
           "CPOS:001;00000001.000000;-0.000000;" & Zero & ";" & Zero & ";"
           & Zero;
      begin
         Position_Lines.Parse (Line, P, OK);
         Assert (OK and then P = (1, 1_000_000, 0, 0, 0, 0), "zeros");
      end;
   end Test_Refused_Positions;

   procedure Add_Tests is
   begin
      Add_Test ("table of labels", Test_Labels'Access);
      Add_Test ("which are answered", Test_Answered'Access);
      Add_Test ("commands without data", Test_Bare'Access);
      Add_Test ("beginnings of lines", Test_Beginnings'Access);
      Add_Test ("labels one character off", Test_Any_Label'Access);
      Add_Test ("numbers, clamped", Test_Numbers'Access);
      Add_Test ("every number from -70,000 to 70,000",
                Test_Every_Number'Access);
      Add_Test ("no numbers", Test_Bad_Numbers'Access);
      Add_Test ("log messages", Test_Log'Access);
      Add_Test ("missions", Test_Missions'Access);
      Add_Test ("lines in a buffer", Test_Parse_Slices'Access);
      Add_Test ("chaos", Test_Parse_Chaos'Access);
      Add_Test ("ends of lines", Test_Line_Ends'Access);
      Add_Test ("long lines", Test_Long_Lines'Access);
      Add_Test ("telnet's commands", Test_Telnet'Access);
      Add_Test ("a random stream", Test_Reader_Chaos'Access);
      Add_Test ("answers", Test_Answers'Access);
      Add_Test ("F18: not found", Test_Not_Found'Access);
      Add_Test ("F18: positions", Test_Positions'Access);
      Add_Test ("F17: the ground of the arena", Test_Ground'Access);
      Add_Test ("F18: random positions", Test_Random_Positions'Access);
      Add_Test ("no positions", Test_Refused_Positions'Access);
      Add_Test ("damaged positions", Test_Damaged_Positions'Access);
   end Add_Tests;

end Monitor_Protocol_Tests;
