--  SPDX-License-Identifier: GPL-3.0-or-later
--  The firmware's state machine, row by row of docs/wire.md.

with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Ada.Strings.Maps;

with Plain_Numbers;
with Robot_Core;        use Robot_Core;
with Robot_Motion;
with Unit_Runs;         use Unit_Runs;

procedure Robot_Core_Tests is

   use type Octet;
   use type Robot_Motion.Micro;
   use type Robot_Motion.Pose;

   CR : constant Octet := 16#0D#;

   Result   : Exchange;
   Complete : Boolean;
   --  Of the last frame sent

   function Bytes (Text : String) return Octets is
      Data : Octets (1 .. Text'Length);
   begin
      for K in Data'Range loop
         Data (K) := Character'Pos (Text (Text'First + K - 1));
      end loop;
      return Data;
   end Bytes;

   function Image (Data : Octets) return String is
      Text : String (1 .. Data'Length);
   begin
      for K in Text'Range loop
         Text (K) := Character'Val (Data (Data'First + K - 1));
      end loop;
      return Text;
   end Image;

   procedure Send_Raw (R : in out Robot; Data : Octets) is
      --  Data as it is
   begin
      Complete := False;
      for Byte of Data loop
         Receive (R, Byte, Complete, Result);
      end loop;
   end Send_Raw;

   function Raw_Answer (R : in out Robot; Data : Octets) return String is
      --  Data and a carriage return; the answer's text, checked to be well
      --  framed, or "" without one
   begin
      Send_Raw (R, Data);
      Assert (not Complete, "a frame ended before its carriage return");
      Send_Raw (R, (1 => CR));
      Assert (Complete, "no frame at a carriage return");
      if Result.Reply.Length = 0 then
         return "";
      end if;
      declare
         Frame : Octets renames Result.Reply.Data (1 .. Result.Reply.Length);
         Text  : Octets renames Frame (1 .. Frame'Last - 2);
      begin
         Assert (Frame (Frame'Last) = CR, "answer without its end");
         Assert (Frame (Frame'Last - 1) = Checksum (Text),
                 "answer with a wrong checksum");
         return Image (Text);
      end;
   end Raw_Answer;

   function Ask (R : in out Robot; Text : String) return String is
     (Raw_Answer (R, Bytes (Text) & Checksum (Bytes (Text))));

   procedure Wait_Microseconds (R : in out Robot; Time : Time_Point) is
   begin
      Advance_To (R, Clock (R) + Time);
   end Wait_Microseconds;

   procedure Wait (R : in out Robot; Ticks : Natural) is
   begin
      Wait_Microseconds (R, Time_Point (Ticks) * Tick);
   end Wait;

   procedure Expect (R : in out Robot; Text, Answer : String) is
      Got : constant String := Ask (R, Text);
   begin
      Assert (Got = Answer,
              "'" & Text & "' answered '" & Got & "', not '" & Answer
              & "', in " & State (R)'Image);
   end Expect;

   procedure Expect_State (R : Robot; State : State_Kind) is
   begin
      Assert (Robot_Core.State (R) = State,
              "in " & Robot_Core.State (R)'Image & ", not in "
              & State'Image);
   end Expect_State;

   function In_State (State : State_Kind) return Robot is
      --  A robot that got there in an ordinary way
      R : Robot;
   begin
      if State /= Off then
         Switch_On (R);
      end if;
      if State not in Off | Start_Up then
         Wait (R, Boot_Ticks);
      end if;
      case State is
         when Off | Start_Up | Idle =>
            null;
         when Run =>
            Expect (R, "u", "O");
         when Movement =>
            Expect (R, "u", "O");
            Expect (R, "M=32767", "O");
         when In_Charge =>
            Set_Charging (R, True);
         when Watchdog_Disabled =>
            Expect (R, "W", "O");
            Wait (R, 3 * (Watchdog_Last + 1));
         when Low_Battery =>
            Set_Battery (R, Typical (Critical));
      end case;
      Expect_State (R, State);
      return R;
   end In_State;

   procedure Play (R : in out Robot; Script : String) is
      --  Its words: "TEXT>ANSWER" and, without a checksum of its own,
      --  "BYTES!ANSWER"; "+N" ticks pass, "~N" microseconds; "=STATE", or "="
      --  for that at the beginning; "on" switches on; "mark" and "still": the
      --  pose is that at the mark. With a value, "battery:" and "plugged:"
      --  set, "watchdog:", "missed:", "total:", "disabled:", "x:", "y:" and
      --  "angle:" are as demanded.
      Start : constant State_Kind := State (R);
      Mark  : Robot_Motion.Pose := Pose (R);

      procedure Check (Is_So : Boolean; Word : String) is
      begin
         Assert (Is_So, Word & " in """ & Script & """ from " & Start'Image
                 & ", now in " & State (R)'Image);
      end Check;

      procedure Carry_Out (Word : String) is
         Gap   : constant Natural :=
           Index (Word, Ada.Strings.Maps.To_Set (">!:"));
         Key   : constant String := Word (Word'First .. Gap - 1);
         Value : constant String :=
           Word (Natural'Max (Gap, Word'First) + 1 .. Word'Last);
      begin
         if Word = "" then
            null;
         elsif Gap > 0 and then Word (Gap) = '>' then
            Check (Ask (R, Key) = Value, Word);
         elsif Gap > 0 and then Word (Gap) = '!' then
            Check (Raw_Answer (R, Bytes (Key)) = Value, Word);
         elsif Key = "battery" then
            Set_Battery (R, (if Value (Value'First) in '0' .. '9'
                             then Centivolts'Value (Value)
                             else Typical (Battery_Level'Value (Value))));
         elsif Key = "plugged" then
            Set_Charging (R, Boolean'Value (Value));
         elsif Key = "watchdog" then
            Check (Watchdog_On (R) = Boolean'Value (Value), Word);
         elsif Gap > 0 then
            Check (Long_Long_Integer'Value (Value) =
                     (if Key = "missed" then Long_Long_Integer (Missed (R))
                      elsif Key = "total"
                      then Long_Long_Integer (Missed_Total (R))
                      elsif Key = "disabled"
                      then Long_Long_Integer (Disabled_Count (R))
                      elsif Key = "x" then Long_Long_Integer (Pose (R).X)
                      elsif Key = "y" then Long_Long_Integer (Pose (R).Y)
                      elsif Key = "angle"
                      then Long_Long_Integer (Pose (R).Angle)
                      else raise Constraint_Error with Word),
                   Word);
         elsif Word = "on" then
            Switch_On (R);
         elsif Word = "mark" then
            Mark := Pose (R);
         elsif Word = "still" then
            Check (Pose (R) = Mark, Word);
         elsif Word = "=" then
            Check (State (R) = Start, Word);
         else
            case Word (Word'First) is
               when '='    =>
                  Check (State (R) = State_Kind'Value (Value), Word);
               when '+'    => Wait (R, Natural'Value (Value));
               when '~'    => Wait_Microseconds (R, Time_Point'Value (Value));
               when others => raise Constraint_Error with Word;
            end case;
         end if;
      end Carry_Out;

   begin
      for Word of Split (Script, ' ') loop
         Carry_Out (Word);
      end loop;
   end Play;

   procedure Play (From : State_Kind; Script : String) is
      R : Robot := In_State (From);
   begin
      Play (R, Script);
   end Play;

   procedure Play_Each (Where, Script : String; Otherwise : String := "") is
      --  Script from each state that Where names, Otherwise from the others,
      --  but those of Off and Low_Battery
   begin
      for State in Start_Up .. Watchdog_Disabled loop
         Play (State,
               (if Index (" " & Where & " ", " " & State'Image & " ") > 0
                then Script else Otherwise));
      end loop;
   end Play_Each;

   Every : constant String :=
     "START_UP IDLE RUN MOVEMENT IN_CHARGE WATCHDOG_DISABLED";

   procedure Test_By_State is

      procedure Try (Order, After : String) is
      begin
         Play_Each ("RUN MOVEMENT", Order & ">O =" & After, Order & ">E =");
      end Try;

   begin
      Play_Each (Every, "pq!E p!E !E xy!E zy!E =");  --  bad checksums
      Play_Each (Every, "p>O t>O a>O v>2 V>3.5 =");
      Play_Each ("MOVEMENT", "b>1", "b>0");
      Play_Each ("RUN MOVEMENT", "w>O =", "w>E =");
      Play_Each ("IDLE", "u>O =Run watchdog:False missed:0",
                 "u>E = watchdog:False");
      Play_Each ("IDLE", "W>O =Run watchdog:True missed:0",
                 "W>E = watchdog:False");
      Try ("M=100", "Movement");
      Try ("M=-100", "Movement");
      Try ("M=32767", "Movement");
      Try ("M=-32768", "Movement");
      Try ("T=90", "Movement");
      Try ("T=-90", "Movement");
      Try ("T=32767", "Movement");
      Try ("T=-32768", "Movement");
      Try ("M=0", "Run");
      Try ("T=0", "Run");
      Play_Each ("IDLE RUN MOVEMENT WATCHDOG_DISABLED",
                 "r>O =Idle watchdog:False mark +5 still", "r>E =");
      Play_Each
        (Every, "z>O =Off mark +20 still p> u> x> pq! =Off watchdog:False");
      Play_Each ("IDLE RUN MOVEMENT WATCHDOG_DISABLED",
                 "p>O ~119999999 = ~1 =Off p> =Off");
   end Test_By_State;

   procedure Test_Charging is
   begin
      Play (Movement, "mark plugged:True =In_Charge +6000 =In_Charge still "
            & "plugged:False =Idle +1199 =Idle");
      Play (Idle, "W>O plugged:True watchdog:False +100 =In_Charge");
      Play (Start_Up, "plugged:True =In_Charge");
      Play (Off, "plugged:True =Off");
   end Test_Charging;

   procedure Test_Battery is
   begin
      Play (Movement, "v>2 battery:Low v>1 battery:Empty v>0 =Movement "
            & "plugged:True v>0 battery:Full v>2");
      Play (Idle, "battery:311 v>0 battery:330 v>0 battery:331 v>1 "
            & "battery:359 v>1 battery:360 v>2 plugged:True v>1 battery:344 "
            & "v>0 battery:345 v>1 battery:389 v>1 battery:390 v>2 "
            & "battery:310 v>0 =In_Charge plugged:False =Low_Battery");

      --  Critical: it is silent, switches itself off, and finds its battery
      --  as bad when switched on again; nothing saves it

      Play (Idle, "W>O M=32767>O +5 battery:Critical =Low_Battery "
            & "watchdog:False mark p> v> b> V> z> u> r> M=0> w> x> pq! +39 "
            & "=Low_Battery still +1 =Off p> on =Low_Battery battery:Full "
            & "=Low_Battery plugged:True =Low_Battery +40 =Off");
      Play (In_Charge,
            "battery:Critical =In_Charge plugged:False =Low_Battery");
   end Test_Battery;

   procedure Test_Busy is
   begin
      Play (Run, "b>0 M=10>O b>1 M=0>O b>0 T=-20>O b>1 T=0>O b>0");
   end Test_Busy;

   procedure Test_Movements is
   begin
      --  They end: 100 mm at 200 mm/s, 90 degrees at 90 degrees/s; endless
      --  ones do not, not even against a wall

      Play (Run, "M=100>O ~499999 =Movement ~1 =Run b>0 "
            & "T=-90>O ~999999 =Movement ~1 =Run "
            & "M=-32768>O " & 100 * "+100 p>O " & "=Movement");

      --  The next one takes the place of the one under way

      Play (Run, "M=32767>O +5 x:500000 T=32767>O +10 x:500000 "
            & "angle:90000000 M=50>O ~250000 =Run y:350000");
   end Test_Movements;

   procedure Test_Watchdog is
      R : Robot := In_State (Run);
   begin
      --  11 ticks are not a miss, 12 are; the third disables

      Play (Idle, "W>O +11 missed:0 +1 missed:1 +11 missed:1 +1 missed:2 "
            & "+11 =Run p>O +1 =Watchdog_Disabled disabled:1 total:3 "
            & "+100 =Watchdog_Disabled total:3");
      Play (Idle, "W>O w>E w>E w>E missed:3 =Run +1 =Watchdog_Disabled "
            & "total:3 disabled:1");

      --  A reload in time forgives

      Play (Idle, "W>O "
            & 10 * "+5 w>E +12 missed:2 +10 w>O missed:0 " & "=Run total:20");
      Play (Idle, "W>O +10 T=32767>O w>O +10 M=100>O w>O +10 =Run w>O "
            & "T=-32768>O +36 =Watchdog_Disabled mark +5 still b>0");
      Play (Watchdog_Disabled, "u>E W>E w>E M=0>E T=5>E = r>O =Idle W>O "
            & "missed:0 +10 w>O");
      for Ticks in 1 .. 20 loop
         Play (R, "w>O +" & Plain_Numbers.Image (Ticks));
      end loop;
      Play (R, "=Run total:0");

      --  For hours: each second, 80 ms early or late in turn

      Play (Idle, "~50000 W>O " & 2_500 * "~920000 w>O ~1080000 w>O "
            & "total:0 =Run");
   end Test_Watchdog;

   procedure Test_Starve is
      R : Robot := In_State (Idle);
   begin
      Play (R, "W>O M=100>O +1");
      Starve (R);
      Play (R, "=Watchdog_Disabled disabled:1 w>E M=0>E r>O =Idle");
   end Test_Starve;

   procedure Test_Start_Up_Time is
      R : Robot;
   begin
      Play (R, "=Off p> ~777777 on =Start_Up ~1599999 =Start_Up u>E ~1 =Idle "
            & "u>O");
      R := In_State (Off);
      Switch_On (R, Boot => 30);
      Play (R, "~2999999 =Start_Up ~1 =Idle");
   end Test_Start_Up_Time;

   procedure Test_Power_Cycle is
      R : Robot := In_State (Idle);
   begin
      Play (R, "W>O M=32767>O +3 battery:Low");
      Send_Raw (R, Bytes ("half a fra"));
      Play (R, "mark on =Start_Up watchdog:False missed:0 p>O v>1 +16 =Idle "
            & "still");
   end Test_Power_Cycle;

   procedure Test_What_Keeps_Awake is
   begin
      --  A valid command does, refused or not; an unknown one and a wrong
      --  checksum do not

      Play (Idle, "p>O +1199 w>E +1199 =Idle x>C pq!E M=>C +1 =Off");
   end Test_What_Keeps_Awake;

   procedure Test_First_Letter_Counts is
   begin
      Play (Idle, "ping>O p?>O battery>0 voltage>2 Version>3.5 up>O =Run "
            & "reset>O =Idle Watchdog>O watchdog:True");
   end Test_First_Letter_Counts;

   procedure Test_Counters is
      R : Robot := In_State (Idle);
   begin
      Assert (Commands (R) = 0, "none yet");
      Play (R, "M=0>E u>O M=0>O T=0>O M=1>O x>C M=0x!E");
      Assert (Commands (R) = 7, "frames" & Commands (R)'Image);
      Assert (Stops (R) = 3, "stops" & Stops (R)'Image);
   end Test_Counters;

   procedure Test_Wheels is
      R : Robot := In_State (Run);
   begin
      --  From the next order on, each as long as it takes; a power cycle
      --  mends nothing

      Play (R, "M=200>O +5");
      Set_Wheels (R, (Speed      => 70,
                      Turn_Speed => 130,
                      Overshoot  => 20,
                      Pull       => 10));
      Play (R, "+5 b>0 x:600000 y:300000 angle:0 "
            & "M=-200>O ~999999 b>1 ~1 b>0 angle:358600000");
      Assert (Pose (R).X in 460_000 .. 460_100
              and then Pose (R).Y in 301_600 .. 301_800, "an arc, slowly");
      Play (R, "on +16 u>O T=90>O ~1199999 b>1 ~1 b>0 angle:139000000");
      Set_Wheels (R, Robot_Motion.Ideal);
      Play (R, "T=-139>O +16 angle:0");
   end Test_Wheels;

   procedure Test_Answer_Frames is
      R : Robot := In_State (Idle);

      procedure Try (Text : String; Answer : Octets) is
      begin
         Send_Raw (R, Bytes (Text) & CR);
         Assert (Result.Reply.Data (1 .. Result.Reply.Length) = Answer & CR,
                 Text);
      end Try;

   begin
      Try ("pp", Bytes ("OO"));
      Try ("ww", Bytes ("EE"));
      Try ("xx", Bytes ("CC"));
      Try ("VV", Bytes ("3.5") & 16#28#);
   end Test_Answer_Frames;

   procedure Test_Checksum is
   begin
      Assert (Checksum (Bytes ("p")) = 16#70#, "one letter");
      Assert (Checksum (Bytes ("pp")) = 0, "two alike");
      Assert (Checksum (Bytes ("M=0")) = 16#40#, "M=0");
      Assert (Checksum ((16#0C#, 16#01#)) = 16#0E#, "0x0D sent as 0x0E");
      Assert (Checksum (Octets'(1 => CR)) = 16#0E#, "0x0D alone");
      Assert (Checksum ((16#0F#, 16#01#)) = 16#0E#, "0x0E itself");
      Assert (Checksum (Bytes ("")) = 0, "nothing");
   end Test_Checksum;

   procedure Test_Checksum_Sent_As_0E is
      R : Robot := In_State (Idle);
   begin
      --  'p' and 0x7D: their exclusive or is 0x0D

      Assert (Raw_Answer (R, (16#70#, 16#7D#, 16#0E#)) = "O",
              "0x0E in place of 0x0D");
      Send_Raw (R, (16#70#, 16#7D#, CR));
      Assert (Complete and then Result.Kind = Bad_Checksum,
              "0x0D ends the frame");
      Assert (Raw_Answer (R, (16#70#, 16#7E#, 16#0E#)) = "O",
              "an exclusive or of 0x0E is itself");
      Assert (Raw_Answer (R, (16#70#, 16#7D#, 16#0F#)) = "E", "0x0F");
   end Test_Checksum_Sent_As_0E;

   procedure Test_NUL_Dropped is
      R : Robot := In_State (Idle);
   begin
      Assert (Raw_Answer (R, (0, 16#70#, 0, 0, 16#70#, 0)) = "O",
              "NULs around a ping");

      --  Nor do they count for the wrap

      Send_Raw (R, (1 .. 200 => 0));
      Assert (Raw_Answer (R, (16#70#, 16#70#)) = "O", "after 200 NULs");

      --  A checksum of 0 never arrives: the text's last byte is then taken
      --  for it. Here it fits: 'p' in "pp".

      Assert (Raw_Answer (R, (16#70#, 16#70#, 0)) = "O", "checksum 0");
      Assert (Raw_Answer (R, (16#78#, 16#08#, 16#70#, 0)) = "C",
              "'x', and 0x70 taken for the checksum");
      Assert (Raw_Answer (R, (16#70#, 16#62#, 16#61#, 16#73#, 0)) = "O",
              "'p', and 0x73 taken for the checksum");
   end Test_NUL_Dropped;

   procedure Test_Wrap_At_50 is
      R : Robot := In_State (Idle);

      Ping : constant Octets := Bytes ("pp");
   begin
      --  49 bytes still are a frame: here 48 letters and their checksum

      declare
         Text : constant Octets (1 .. 48) := (1 => 16#70#, others => 16#20#);
      begin
         Assert (Raw_Answer (R, Text & Checksum (Text)) = "O", "49 bytes");
      end;

      --  The 50th throws all away; what follows is a frame of its own

      Assert (Raw_Answer (R, (1 .. 50 => 16#70#)) = "E", "50 bytes");
      Assert (Raw_Answer (R, (1 .. 51 => 16#70#)) = "E", "51 bytes");
      Assert (Raw_Answer (R, (1 .. 50 => 16#2A#) & Ping) = "O",
              "50 bytes and a ping");
      Assert (Raw_Answer (R, (1 .. 100 => 16#2A#) & Ping) = "O",
              "100 bytes and a ping");
      Assert (Raw_Answer (R, (1 .. 49 => 16#2A#) & Ping) = "E",
              "49 bytes and a ping");
      Assert (Raw_Answer (R, Ping) = "O", "and nothing is left of it");
   end Test_Wrap_At_50;

   procedure Test_Unknown is
   begin
      for State in Start_Up .. Watchdog_Disabled loop
         declare
            R : Robot := In_State (State);
         begin
            for Code in Octet range 1 .. 255 loop
               if Character'Val (Code)
                 not in 'p' | 'r' | 'u' | 'W' | 'w' | 'v' | 'b' | 'V' | 'z'
                   | 't' | 'a'
                 and then Code /= CR
               then
                  Expect (R, (1 => Character'Val (Code)), "C");
               end if;
            end loop;
            Expect_State (R, State);
         end;
      end loop;
   end Test_Unknown;

   procedure Test_Numbers is
      R : Robot := In_State (Run);

      procedure Accepts (Order : String; Kind : Command_Kind; Value : Integer)
      is
      begin
         Expect (R, Order, "O");
         Assert (Result.Kind = Kind and then Result.Amount = Value,
                 Order & " read as" & Result.Amount'Image);
      end Accepts;

   begin
      for Row of Split
        ("0:0|1:1|-1:-1|+7:7|  42:42|0000000000000000000000000123:123"
         & "|12abc:12|12 34:12|1-2:1|32766:32766|32767:32767|32768:32767"
         & "|99999999999999999999999999999:32767|-32767:-32767|-32768:-32768"
         & "|-32769:-32768|-99999999999999999999999999999:-32768")
      loop
         declare
            Number : constant String  := Split (Row, ':') (1);
            Value  : constant Integer := Integer'Value (Split (Row, ':') (2));
         begin
            Accepts ("M=" & Number, Move, Value);
            Accepts ("T=" & Number, Turn, Value);
         end;
      end loop;

      for Letter of String'("MT") loop
         for Rest of Split ("|=|=-|=+|=- 1|=+-1|=x|= |12| =12|:12") loop
            Expect (R, "M=0", "O");
            Expect (R, Letter & Rest, "C");
            Expect_State (R, Run);
         end loop;
      end loop;
   end Test_Numbers;

   procedure Test_Window_Edges is

      procedure Try (Ticks : Natural; Answer, Misses : String) is
         R     : Robot := In_State (Idle);
         After : constant String :=
           " +" & Plain_Numbers.Image (Ticks) & " w>" & Answer
           & " missed:" & Misses;
      begin
         Play (R, "W>O" & After);
         if Ticks <= Watchdog_Last then
            Assert (Result.Ticks = Ticks, "ticks" & Result.Ticks'Image);
         end if;
         --  and after a reload
         Play (R, "+10 w>O missed:0" & After & " =Run");
      end Try;

   begin
      Try (0, "E", "1");
      Try (1, "E", "1");
      Try (8, "E", "1");
      Try (9, "O", "0");
      Try (10, "O", "0");
      Try (11, "O", "0");
      Try (12, "E", "2");  --  missed by the tick, then refused as too early
   end Test_Window_Edges;

   procedure Test_Window_Phase is
   begin
      --  The ticks run on from power on: what counts is how many of them
      --  fell between start and reload

      Play (Idle, "~10000 W>O ~889999 w>E");
      Play (Idle, "~10000 W>O ~890000 w>O");
      Play (Idle, "~90000 W>O ~809999 w>E");
      Play (Idle, "~90000 W>O ~810000 w>O");
      Play (Idle, "~10000 W>O ~1189999 w>O");
      Play (Idle, "~10000 W>O ~1190000 w>E");
      Play (Idle, "~90000 W>O ~1109999 w>O");
      Play (Idle, "~90000 W>O ~1110000 w>E");
   end Test_Window_Phase;

   procedure Test_Time_Goes_One_Way is
      R : Robot := In_State (Idle);
   begin
      Advance_To (R, Clock (R) - 50_000);
      Expect_State (R, Idle);
      Advance_To (R, Time_Point'Last);
      Expect_State (R, Off);
      Switch_On (R);
      Expect (R, "p", "O");
   end Test_Time_Goes_One_Way;

begin
   Run_Test ("checksum", Test_Checksum'Access);
   Run_Test ("answer frames", Test_Answer_Frames'Access);
   Run_Test ("checksum 0x0D sent as 0x0E", Test_Checksum_Sent_As_0E'Access);
   Run_Test ("NUL dropped", Test_NUL_Dropped'Access);
   Run_Test ("wrap at 50 bytes", Test_Wrap_At_50'Access);
   Run_Test ("only the first letter counts", Test_First_Letter_Counts'Access);
   Run_Test ("unknown letter: C", Test_Unknown'Access);
   Run_Test ("numbers of M and T", Test_Numbers'Access);
   Run_Test ("start-up", Test_Start_Up_Time'Access);
   Run_Test ("each command by state", Test_By_State'Access);
   Run_Test ("busy", Test_Busy'Access);
   Run_Test ("battery", Test_Battery'Access);
   Run_Test ("movements end or are replaced", Test_Movements'Access);
   Run_Test ("watchdog window: 8, 9, 11, 12 ticks", Test_Window_Edges'Access);
   Run_Test ("watchdog window: phase of the ticks", Test_Window_Phase'Access);
   Run_Test ("watchdog: misses, forgiven, disabled, for hours",
             Test_Watchdog'Access);
   Run_Test ("what keeps it awake", Test_What_Keeps_Awake'Access);
   Run_Test ("in charge", Test_Charging'Access);
   Run_Test ("power cycle", Test_Power_Cycle'Access);
   Run_Test ("its watchdog disables it", Test_Starve'Access);
   Run_Test ("wheels not ideal", Test_Wheels'Access);
   Run_Test ("counters", Test_Counters'Access);
   Run_Test ("time", Test_Time_Goes_One_Way'Access);
end Robot_Core_Tests;
