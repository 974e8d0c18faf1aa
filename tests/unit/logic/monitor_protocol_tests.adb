--  SPDX-License-Identifier: GPL-3.0-or-later
--  The monitor's lines: every label, numbers, line ends, answers, positions.

with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Ada.Strings.Maps;  use Ada.Strings.Maps;

with Commands; use Commands;
with Missions;
with Monitor.Notices;  use Monitor.Notices;
with Monitor.Protocol;  use Monitor.Protocol;
with Position_Lines;
with Unit_Runs; use Unit_Runs;

procedure Monitor_Protocol_Tests is

   LF : Character renames Line_Feed;
   CR : Character renames Carriage_Return;

   function Label (Name : Command_Name) return Label_Text is
     (Table (Name).Label);

   procedure Check (Line : Short_Text; Text : String) is
      --  Line is Text and a line feed.
   begin
      Assert (Line.Data (1 .. Line.Length) = Text & LF,
              Line.Data (1 .. Line.Length) & ", not " & Text);
   end Check;

   function Formatted (P : Position) return String is
      --  Without the line feed, which is checked.
      Line : constant Short_Text := Position_Line (P);
   begin
      Assert (Line.Data (Line.Length) = LF, "line feed");
      return Line.Data (1 .. Line.Length - 1);
   end Formatted;

   function Image (Value : Micro) return String is
      --  Six decimals, by other means than the package's.
      Digits_Only : constant String :=
        Trim
          (Long_Long_Integer'Image (Long_Long_Integer (abs Value)),
           Ada.Strings.Left);
      Filled : constant String :=
        (if Digits_Only'Length >= 7 then Digits_Only
         else Tail (Digits_Only, 7, '0'));
   begin
      return (if Value < 0 then "-" else "")
        & Filled (Filled'First .. Filled'Last - 6) & "."
        & Filled (Filled'Last - 5 .. Filled'Last);
   end Image;

   procedure Check_Line (Text, Expected : String) is
      --  Text and a line feed are the line Expected.
      R       : Line_Reader;
      Line    : Line_Buffer := (others => '.');
      Last    : Line_Length;
      Ignored : Boolean;
   begin
      for C of String'(Text & LF) loop
         Accept_Character (R, C, Ignored);
      end loop;
      Get_Line (R, Line, Last);
      Assert (Line (1 .. Last) = Expected, "line " & Expected);
      Assert ((for all I in Last + 1 .. Line'Last => Line (I) = '.'),
              "behind " & Expected);
   end Check_Line;

   procedure Check_Position (P : Position) is
      --  Formatted as expected, and read back.
      Text : constant String := Formatted (P);
      Q    : Position;
      OK   : Boolean;
   begin
      Assert (Text = "CPOS:" & Trim
                (Integer'Image (P.Id), Ada.Strings.Left)
              & ";" & Image (P.Angle) & ";" & Image (P.Cx) & ";"
              & Image (P.Cy) & ";" & Image (P.Dx) & ";" & Image (P.Dy),
              "text " & Text);
      Position_Lines.Parse (Text, Q, OK);
      Assert (OK and then Q = P, "read back " & Text);
   end Check_Position;

   procedure Test_Table is
   begin
      for Name in Command_Name loop
         Assert (Is_Answered (Name) =
                   (Name not in Confirm_Arena | Reject_Arena | Sign_Of_Life
                      | Log_Message),
                 Name'Image & " is answered");
         Assert (Is_By_Hand (Name) =
                   (Name in Close_Robot | Reset_Robot | Power_Off_Robot
                      | Go_Forward | Go_Backward | Go_Left | Go_Right
                      | Move_Robot | Turn_Robot | Stop_Robot | Abort_Mission),
                 Name'Image & " is by hand");
      end loop;
   end Test_Table;

   procedure Test_Answers is

      function Said (Text : String) return Commands.Outcome is
        ((Text   => (Data   => Head
                       (Text, Commands.Answer_Length'Last),
                     Length => Text'Length),
          others => <>));
      --  The robot has answered with Text

   begin
      Check (Reply_To (Get_Battery, Said ("2")), "RBLV:2");
      Check (Reply_To (Get_State, Said ("1")), "RCST:1");
      Check (Reply_To (Get_Version, Said ("3.5")), "RVER:3.5");
      Check (Reply_To (Ping_Robot, Said ("O")), "AACK");
      Check (Battery_Notice (Said ("0")), "RBLV:0");
      Check (Progress_Line (1, 1, 0), "MPRG:1;1;0");
      Check (Progress_Line (3, 12, 457), "MPRG:3;12;457");
      Check (Progress_Line (64, 64, 9_999_999), "MPRG:64;64;9999999");
      Check (End_Line (Missions.Completed, 0), "MEND:done");
      Check (End_Line (Missions.No_Progress, 0),
             "MEND:aborted;no progress for 2 s");
      Check (End_Line (Missions.Leg_Too_Long, 0),
             "MEND:aborted;leg takes longer than its time");
      Check (End_Line (Missions.No_Way, 0), "MEND:aborted;no permitted way");
      Check (End_Line (Missions.Turns_Amiss, 8),
             "MEND:aborted;robot turns 8 % of what is asked");
      Check (End_Line (Missions.Drives_Amiss, 210),
             "MEND:aborted;robot drives 210 % of what is asked");
      Check (Battery_Notice ((Kind => Commands.Timed_Out, others => <>)),
             "RBLV:-1");
   end Test_Answers;

   procedure Test_Beginnings is
      --  Every part of a message may become one, and nothing else
      R        : Line_Reader;
      Complete : Boolean;
      Verdict  : Beginning;
      Line     : Line_Buffer;
      Last     : Line_Length;

      procedure Check (All_Of_It : String; Expected : Beginning) is
         --  Whole, and cut in two anywhere
         Text : constant String (1 .. All_Of_It'Length) := All_Of_It;
      begin
         for Cut in 0 .. Text'Length loop
            R := (others => <>);
            Judge (R, Text (1 .. Cut), Verdict, Line, Last);
            Assert (Verdict in Undecided | Expected
                    and then Last <= Cut
                    and then Line (1 .. Last) = Text (1 .. Last),
                    "the beginning of " & Text);
            if Verdict = Undecided then
               for C of Text (1 .. Cut) loop
                  Accept_Character (R, C, Complete);
               end loop;
               Judge (R, Text (Cut + 1 .. Text'Last), Verdict, Line, Last);
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

   procedure Test_Line_Ends is
      Longest : constant String := (1 .. Max_Line => 'x');
   begin
      --  "~" is a carriage return
      for Row of Split
        ("ROPN=ROPN|ROPN~=ROPN|=|~=|~~=~|~RPIN=~RPIN|RP~IN~=RP~IN"
         & "|RP~~IN=RP~~IN|RMOV:-12=RMOV:-12|" & Longest & "=" & Longest & "|"
         & Longest & "~=" & Longest & "|" & Longest & "~~=|" & Longest & "x=|"
         & Longest & "xx=")
      loop
         declare
            Part : constant Line_Vectors.Vector := Split
              (Translate (Row, To_Mapping ("~", (1 => CR))), '=');
         begin
            Check_Line (Part (1), Part (2));
         end;
      end loop;
   end Test_Line_Ends;

   procedure Test_Missions is

      use type Missions.Unit;
   begin
      for K in Mission_Command loop
         Assert (Measure (K) = (if Label (K) in "MGTO" | "MPTH"
                                then Missions.Pixels
                                else Missions.Centimetres),
                 "the unit of " & Label (K));
         Assert (Most_Points (K) =
                   (if Label (K) in "MGTO" | "MGCM" then 1 else 64), "most");
      end loop;
   end Test_Missions;

   procedure Test_Positions is
      Edge : constant array (1 .. 22) of Micro :=
        (0, 1, -1, 9, -9, 10, 99_999, -99_999, 100_000, 500_000, -500_000,
         999_999, -999_999, 1_000_000, -1_000_000, 1_000_001, -1_000_001,
         180_000_000, -179_999_999, Micro'First, Micro'Last,
         Micro'Last - 1);
   begin
      Assert (Formatted (Not_Found) =
              "CPOS:-1;0.000000;-1.000000;-1.000000;0.000000;0.000000",
              "identifier -1, centre (-1, -1)");
      Check_Position (Not_Found);
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
   begin
      Check
        (Ground
           ((80, 60), 8,
            (100_000_000, 50_500_000, 540_000_001, -400_000,
             600_000_000, 420_000_000, 40_000_000, 400_000_000)),
         "CARN:80;60;8;100.000000;50.500000;540.000001;-0.400000;600.000000"
         & ";420.000000;40.000000;400.000000");
      Check (Ground ((1_000, 1_000), 9, (others => Coordinate'Last)),
             "CARN:1000;1000;9" & 8 * ";9999.999999");
      Check (Ground ((30, 30), 0, (others => Coordinate'First)),
             "CARN:30;30;0" & 8 * ";-999.999999");
   end Test_Ground;

   function Path_Of (Text : String) return Missions.Path is
      --  Of centimetres. Count 0: no path
      P     : Missions.Path;
      Valid : Boolean;
   begin
      Parse (Text, Text'First, Missions.Centimetres, Missions.Max_Points, P,
             Valid);
      return P;
   end Path_Of;

   procedure Test_Coordinates is
      --  Each first and second
      use type Missions.Point;
   begin
      for Row of Split
        ("0=0|-0=0|7=7_000_000|-7=-7_000_000|007=7_000_000|0000001=1_000_000"
         & "|9999999=9_999_999_000_000|9999999.999999=9_999_999_999_999"
         & "|-9999999.999999=-9_999_999_999_999|0.1=100_000|0.12=120_000"
         & "|0.123=123_000|0.1234=123_400|0.12345=123_450|0.123456=123_456"
         & "|-0.000001=-1|-12.50=-12_500_000|320.5=320_500_000")
      loop
         declare
            Text  : constant String := Split (Row, '=') (1);
            Value : constant Missions.Millionths :=
              Missions.Millionths'Value (Split (Row, '=') (2));
            P     : constant Missions.Path :=
              Path_Of (Text & ";5;7;" & Text);
         begin
            Assert (P.Count = 2 and then P.Points (1) = (Value, 5_000_000)
                    and then P.Points (2) = (7_000_000, Value), Row);
         end;
      end loop;
   end Test_Coordinates;

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

      procedure Check_Skipped (Command : String) is
         R       : Line_Reader;
         Verdict : Beginning;
         Line    : Line_Buffer;
         Last    : Line_Length;
         Text    : constant String := Command & "RSTP" & Command & LF;
      begin
         Check_Line (Command, "");
         Check_Line (Command & "RSTP", "RSTP");
         Check_Line ("RSTP" & Command, "RSTP");
         Check_Line (Command & "RSTP" & Command & CR, "RSTP");
         Check_Line ("RS" & Command & "TP", "RS" & Command & "TP");
         for Cut in Text'Range loop
            Judge (R, Text (1 .. Cut), Verdict, Line, Last);
            Assert (Verdict = (if Cut = Text'Last then Known else Undecided),
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
         Check_Line (Telnet_Mark & "RSTP" & Part, Telnet_Mark & "RSTP" & Part);
         if Part /= Character'Val (16#F0#) then
            Check_Line (Telnet_Mark & Part, (if Part = Telnet_Mark then ""
                                             else Telnet_Mark & Part));
         end if;
      end loop;
      Check_Line ("RSTP" & Telnet_Mark, "RSTP" & Telnet_Mark);
      Check_Line (Octets ("FF FA") & "RSTP", Octets ("FF FA") & "RSTP");
   end Test_Telnet;

   procedure Test_Refused_Positions is

      Zero : constant String := "0.000000";
      Four : constant String := Zero & ";" & Zero & ";" & Zero & ";" & Zero;

      P  : Position;
      OK : Boolean;

      procedure Refuse (Line : String) is
      begin
         Position_Lines.Parse (Line, P, OK);
         Assert (not OK and then P = Not_Found, "no position: " & Line);
      end Refuse;

   begin
      for Line of Split
        ("|CPOS|CPOS:|CPOS:1|CPOS:;;;;;|CPOS:1;" & Four & "|CPOS:1;" & Four
         & ";|CPOS:1;" & Four & ";" & Zero & ";|CPOS:1;" & Four & ";" & Zero
         & ";" & Zero & "|CPOS:1;" & Four & ";" & Zero & LF)
      loop
         Refuse (Line);
      end loop;
      for Start of Split
        ("CIMG:1|CPOS;1|CPOS:|CPOS:-|CPOS:-2|CPOS:1000|CPOS: 1")
      loop
         Refuse (Start & ";" & Four & ";" & Zero);
      end loop;
      for Field of Split
        ("|0|-|.000000|-.000000|0.00000|0.0000000|0,000000|+0.000000"
         & "|--1.000000|1e.000000|nan|10000000.000001|-10000000.000001"
         & "|100000000.000000")
      loop
         Refuse ("CPOS:1;" & Field & ";" & Four);
         Refuse ("CPOS:1;" & Four & ";" & Field);
      end loop;

      --  Zeros in front and a negative zero do no harm

      Position_Lines.Parse
        ("CPOS:001;00000001.000000;-0.000000;" & Zero & ";" & Zero & ";"
         & Zero, P, OK);
      Assert (OK and then P = (1, 1_000_000, 0, 0, 0, 0), "zeros");
   end Test_Refused_Positions;

begin
   Run_Test ("orders by hand, and what is answered", Test_Table'Access);
   Run_Test ("beginnings of lines", Test_Beginnings'Access);
   Run_Test ("missions", Test_Missions'Access);
   Run_Test ("coordinates and separators of a path", Test_Coordinates'Access);
   Run_Test ("ends of lines", Test_Line_Ends'Access);
   Run_Test ("telnet's commands", Test_Telnet'Access);
   Run_Test ("answers", Test_Answers'Access);
   Run_Test ("F18: positions", Test_Positions'Access);
   Run_Test ("F17: the ground of the arena", Test_Ground'Access);
   Run_Test ("no positions", Test_Refused_Positions'Access);
end Monitor_Protocol_Tests;
