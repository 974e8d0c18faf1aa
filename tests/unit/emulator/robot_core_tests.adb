--  SPDX-License-Identifier: GPL-3.0-or-later
--  The firmware's state machine, row by row of docs/wire.md.

with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Ada.Strings.Maps;  use Ada.Strings.Maps;

with Robot_Core;        use Robot_Core;
with Robot_Motion;
with Unit_Runs;         use Unit_Runs;

procedure Robot_Core_Tests is

   use type Octet;
   use type Robot_Motion.Micro;
   use type Robot_Motion.Pose;

   CR : constant Octet := 16#0D#;

   R      : Robot;
   Start  : State_Kind;         --  of R
   Mark   : Robot_Motion.Pose;
   Result : Exchange;           --  of the last frame sent

   function Bytes (Text : String) return Octets is
      --  Its characters, "_" a blank; after "$" two hexadecimal digits each,
      --  with commas in between
   begin
      if Index (Text, "$") = Text'First then
         return Data : Octets (1 .. Text'Length / 3) do
            for K in Data'Range loop
               Data (K) := Octet'Value
                 ("16#" & Text (Text'First + 3 * K - 2
                                .. Text'First + 3 * K - 1) & "#");
            end loop;
         end return;
      else
         return Data : Octets (1 .. Text'Length) do
            for K in Data'Range loop
               Data (K) := Character'Pos (Text (Text'First + K - 1));
               if Data (K) = Character'Pos ('_') then
                  Data (K) := Character'Pos (' ');
               end if;
            end loop;
         end return;
      end if;
   end Bytes;

   procedure Send_Raw (Data : Octets; Ends : Boolean := False) is
      --  Data as it is: the last one ends a frame, or none
      Complete : Boolean;
   begin
      for K in Data'Range loop
         Receive (R, Data (K), Complete, Result);
         Assert (Complete = (Ends and then K = Data'Last), "end of a frame");
      end loop;
   end Send_Raw;

   function Answer (Data : Octets) return String is
      --  To Data and a carriage return; the answer's text, checked to be well
      --  framed, or "" without one
   begin
      Send_Raw (Data & CR, Ends => True);
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
         return Shown : String (Text'Range) do
            for K in Shown'Range loop
               Shown (K) := Character'Val (Text (K));
            end loop;
         end return;
      end;
   end Answer;

   procedure Pass (Time : Robot_Motion.Micro) is
      --  Microseconds
   begin
      Advance_To (R, Clock (R) + Time);
   end Pass;

   function Way_To (State : State_Kind) return String is
     (case State is
         when Off               => "",
         when Start_Up          => "on",
         when Idle              => "on +16",
         when Run               => "on +16 u>O",
         when Movement          => "on +16 u>O M=32767>O",
         when In_Charge         => "on +16 plugged:True",
         when Watchdog_Disabled => "on +16 W>O +36",
         when Low_Battery       => "on +16 battery:Critical");

   function Number (Key : String) return Long_Long_Integer is
     (if Key = "missed" then Long_Long_Integer (Missed (R))
      elsif Key = "total" then Long_Long_Integer (Missed_Total (R))
      elsif Key = "disabled" then Long_Long_Integer (Disabled_Count (R))
      elsif Key = "commands" then Long_Long_Integer (Commands (R))
      elsif Key = "stops" then Long_Long_Integer (Stops (R))
      elsif Key = "ticks" then Long_Long_Integer (Result.Ticks)
      elsif Key = "amount" then Long_Long_Integer (Result.Amount)
      elsif Key = "x" then Long_Long_Integer (Pose (R).X)
      elsif Key = "y" then Long_Long_Integer (Pose (R).Y)
      elsif Key = "angle" then Long_Long_Integer (Pose (R).Angle)
      else raise Constraint_Error with Key);

   procedure Play (Script : String) is
      --  Its words: "@STATE" takes a new robot that got there in an ordinary
      --  way; "TEXT>ANSWER" and, without a checksum of its own,
      --  "BYTES!ANSWER"; "&BYTES" ends no frame; "+N" ticks pass, "~N"
      --  microseconds, "last" all that there is; "=STATE", or "=" for that of
      --  "@"; "on" switches on, "on:N" for a start-up of N ticks; "starve";
      --  "mark" and "still": the pose is that at the mark. With a value,
      --  "battery:" and "plugged:" set; "watchdog:", "kind:" and numbers are
      --  as demanded.

      procedure Check (Is_So : Boolean; Word : String) is
      begin
         Assert (Is_So, Word & " in """ & Script & """ from " & Start'Image
                 & ", now in " & State (R)'Image);
      end Check;

      procedure Carry_Out (Word : String) is
         Asked : constant Natural := Index (Word, To_Set (">!"));
         Gap   : constant Natural :=
           (if Asked > 0 then Asked else Index (Word, ":"));
         Key   : constant String := Word (Word'First .. Gap - 1);
         Value : constant String :=
           Word (Natural'Max (Gap, Word'First) + 1 .. Word'Last);
      begin
         if Asked > 0 then
            Check (Answer (if Word (Gap) = '!' then Bytes (Key)
                           else Bytes (Key) & Checksum (Bytes (Key)))
                   = Value, Word);
         elsif Key = "battery" then
            Set_Battery (R, (if Value (Value'First) in '0' .. '9'
                             then Centivolts'Value (Value)
                             else Typical (Battery_Level'Value (Value))));
         elsif Key = "plugged" then
            Set_Charging (R, Boolean'Value (Value));
         elsif Key = "on" then
            Switch_On (R, Boot => Tick_Count'Value (Value));
         elsif Key = "watchdog" then
            Check (Watchdog_On (R) = Boolean'Value (Value), Word);
         elsif Key = "kind" then
            Check (Result.Kind = Command_Kind'Value (Value), Word);
         elsif Gap > 0 then
            Check (Long_Long_Integer'Value (Value) = Number (Key), Word);
         elsif Word = "on" then
            Switch_On (R);
         elsif Word = "starve" then
            Starve (R);
         elsif Word = "last" then
            Advance_To (R, Time_Point'Last);
         elsif Word = "mark" then
            Mark := Pose (R);
         elsif Word = "still" then
            Check (Pose (R) = Mark, Word);
         elsif Word = "=" then
            Check (State (R) = Start, Word);
         elsif Word /= "" then
            case Word (Word'First) is
               when '@'    =>
                  declare
                     New_One : Robot;
                  begin
                     R := New_One;
                  end;
                  Start := State_Kind'Value (Value);
                  Play (Way_To (Start) & " =");
               when '='    =>
                  Check (State (R) = State_Kind'Value (Value), Word);
               when '&'    => Send_Raw (Bytes (Value));
               when '+'    => Pass (Robot_Motion.Micro'Value (Value) * Tick);
               when '~'    => Pass (Robot_Motion.Micro'Value (Value));
               when others => raise Constraint_Error with Word;
            end case;
         end if;
      end Carry_Out;

   begin
      for Word of Split (Script, ' ') loop
         Carry_Out (Word);
      end loop;
   end Play;

   procedure Play_Each (Where, Script : String; Otherwise : String := "") is
      --  Script from each state that Where names, Otherwise from the others,
      --  but those of Off and Low_Battery
   begin
      for State in Start_Up .. Watchdog_Disabled loop
         Play ("@" & State'Image & " "
               & (if Index (" " & Where & " ", " " & State'Image & " ") > 0
                  then Script else Otherwise));
      end loop;
   end Play_Each;

   Every : constant String :=
     "START_UP IDLE RUN MOVEMENT IN_CHARGE WATCHDOG_DISABLED";

   procedure Test_By_State is
   begin
      Play_Each (Every, "pq!E p!E !E xy!E zy!E =");  --  bad checksums
      Play_Each (Every, "p>O t>O a>O v>2 V>3.5 =");
      Play_Each ("MOVEMENT", "b>1", "b>0");
      Play_Each ("RUN MOVEMENT", "w>O =", "w>E =");
      Play_Each ("IDLE", "u>O =Run watchdog:False missed:0",
                 "u>E = watchdog:False");
      Play_Each ("IDLE", "W>O =Run watchdog:True missed:0",
                 "W>E = watchdog:False");
      for Order of Split ("M=100|M=-100|M=32767|M=-32768|T=90|T=-90|T=32767"
                          & "|T=-32768|M=0|T=0")
      loop
         Play_Each ("RUN MOVEMENT",
                    Order & ">O =" & (if Order in "M=0" | "T=0" then "Run"
                                      else "Movement"), Order & ">E =");
      end loop;
      Play_Each ("IDLE RUN MOVEMENT WATCHDOG_DISABLED",
                 "r>O =Idle watchdog:False mark +5 still", "r>E =");
      Play_Each
        (Every, "z>O =Off mark +20 still p> u> x> pq! =Off watchdog:False");
      Play_Each ("IDLE RUN MOVEMENT WATCHDOG_DISABLED",
                 "p>O ~119999999 = ~1 =Off p> =Off");
   end Test_By_State;

   procedure Test_Wheels is
   begin
      --  From the next order on, each as long as it takes; a power cycle
      --  mends nothing

      Play ("@Run M=200>O +5");
      Set_Wheels (R, (Speed      => 70,
                      Turn_Speed => 130,
                      Overshoot  => 20,
                      Pull       => 10));
      Play ("+5 b>0 x:600000 y:300000 angle:0 "
            & "M=-200>O ~999999 b>1 ~1 b>0 angle:358600000");
      Assert (Pose (R).X in 460_000 .. 460_100
              and then Pose (R).Y in 301_600 .. 301_800, "an arc, slowly");
      Play ("on +16 u>O T=90>O ~1199999 b>1 ~1 b>0 angle:139000000");
      Set_Wheels (R, Robot_Motion.Ideal);
      Play ("T=-139>O +16 angle:0");
   end Test_Wheels;

   procedure Test_Unknown is
      Digit : constant String := "0123456789ABCDEF";
   begin
      for Code in 1 .. 255 loop
         if Code /= 13
           and then Index ("pruWwvbVzta", (1 => Character'Val (Code))) = 0
         then
            Play_Each (Every, "$" & Digit (Code / 16 + 1)
                       & Digit (Code mod 16 + 1) & ">C =");
         end if;
      end loop;
   end Test_Unknown;

   procedure Test_Numbers is
   begin
      Play ("@Run");
      for Row of Split
        ("0:0|1:1|-1:-1|+7:7|__42:42|0000000000000000000000000123:123"
         & "|12abc:12|12_34:12|1-2:1|32766:32766|32767:32767|32768:32767"
         & "|99999999999999999999999999999:32767|-32767:-32767|-32768:-32768"
         & "|-32769:-32768|-99999999999999999999999999999:-32768")
      loop
         for Kind of Split ("Move|Turn") loop
            Play (Kind (Kind'First) & "=" & Split (Row, ':') (1)
                  & ">O kind:" & Kind & " amount:" & Split (Row, ':') (2));
         end loop;
      end loop;

      for Letter of String'("MT") loop
         for Rest of Split ("|=|=-|=+|=-_1|=+-1|=x|=_|_12|_=12|:12") loop
            Play ("M=0>O " & Letter & Rest & ">C =Run");
         end loop;
      end loop;
   end Test_Numbers;

   function Edge (Ticks, Outcome : String) return String is
     ("@Idle W>O +" & Ticks & " w>" & Outcome & " +10 w>O missed:0 +" & Ticks
      & " w>" & Outcome & " =Run ");
   --  A reload after a start and after a reload

begin
   Run_Scripts
     (Play'Access,
      "checksums: @Idle pp!O p_P!O @Run M=0@!O"

      --  'p' and 0x7D: their exclusive or is 0x0D, that of 0x7E is 0x0E
      & "|checksum 0x0D sent as 0x0E: @Idle $70,7D,0E!O "
      & "$70,7D!E kind:Bad_Checksum $70,7E,0E!O $70,7D,0F!E"

      --  Nor do they count for the wrap. A checksum of 0 never arrives: the
      --  text's last byte is then taken for it. Here it fits: 'p' in "pp"
      & "|NUL dropped: @Idle $00,70,00,00,70,00!O &$00" & 199 * ",00"
      & " pp!O $70,70,00!O $78,08,70,00!C $70,62,61,73,00!O"

      --  49 bytes still are a frame. The 50th throws all away; what follows
      --  is a frame of its own, and nothing is left of it
      & "|wrap at 50 bytes: @Idle p" & 47 * "x" & ">O " & 50 * "p" & "!E "
      & 51 * "p" & "!E " & 50 * "*" & "pp!O " & 100 * "*" & "pp!O "
      & 49 * "*" & "pp!E pp!O"

      & "|only the first letter counts: @Idle ping>O p?>O battery>0 "
      & "voltage>2 Version>3.5 up>O =Run reset>O =Idle Watchdog>O "
      & "watchdog:True"

      & "|start-up: @Off = p> ~777777 on =Start_Up ~1599999 =Start_Up u>E ~1 "
      & "=Idle u>O @Off on:30 ~2999999 =Start_Up ~1 =Idle"

      & "|busy: @Run b>0 M=10>O b>1 M=0>O b>0 T=-20>O b>1 T=0>O b>0"

      --  Critical: it is silent, switches itself off, and finds its battery
      --  as bad when switched on again; nothing saves it
      & "|battery: @Movement battery:Low v>1 battery:Empty v>0 =Movement "
      & "plugged:True v>0 battery:Full v>2 "
      & "@Idle battery:311 v>0 battery:330 v>0 battery:331 v>1 battery:359 "
      & "v>1 battery:360 v>2 plugged:True v>1 battery:344 v>0 battery:345 "
      & "v>1 battery:389 v>1 battery:390 v>2 battery:310 v>0 =In_Charge "
      & "plugged:False =Low_Battery "
      & "@Idle W>O M=32767>O +5 battery:Critical =Low_Battery "
      & "watchdog:False mark p> v> b> V> z> u> r> M=0> w> x> pq! +39 "
      & "=Low_Battery still +1 =Off p> on =Low_Battery battery:Full "
      & "=Low_Battery plugged:True =Low_Battery +40 =Off "
      & "@In_Charge battery:Critical =In_Charge plugged:False =Low_Battery"

      --  100 mm at 200 mm/s, 90 degrees at 90 degrees/s; endless ones do not
      --  end, not even against a wall. The next one takes the place of the
      --  one under way
      & "|movements end or are replaced: @Run M=100>O ~499999 =Movement ~1 "
      & "=Run b>0 T=-90>O ~999999 =Movement ~1 =Run M=-32768>O "
      & 100 * "+100 p>O " & "=Movement @Run M=32767>O +5 x:500000 T=32767>O "
      & "+10 x:500000 angle:90000000 M=50>O ~250000 =Run y:350000"

      & "|watchdog window, 8 ticks: "
      & Edge ("0", "E missed:1 ticks:0") & Edge ("1", "E missed:1 ticks:1")
      & Edge ("8", "E missed:1 ticks:8")
      & "|watchdog window, 9 to 11 ticks: " & Edge ("9", "O missed:0 ticks:9")
      & Edge ("10", "O missed:0 ticks:10") & Edge ("11", "O missed:0 ticks:11")
      --  missed by the tick, then refused as too early
      & "|watchdog window, 12 ticks: " & Edge ("12", "E missed:2")

      --  The ticks run on from power on: what counts is how many of them
      --  fell between start and reload
      & "|watchdog window, phase of the ticks: "
      & "@Idle ~10000 W>O ~889999 w>E @Idle ~10000 W>O ~890000 w>O "
      & "@Idle ~90000 W>O ~809999 w>E @Idle ~90000 W>O ~810000 w>O "
      & "@Idle ~10000 W>O ~1189999 w>O @Idle ~10000 W>O ~1190000 w>E "
      & "@Idle ~90000 W>O ~1109999 w>O @Idle ~90000 W>O ~1110000 w>E"

      --  11 ticks are not a miss, 12 are; the third disables
      & "|watchdog, misses: @Idle W>O +11 missed:0 +1 missed:1 +11 missed:1 "
      & "+1 missed:2 +11 =Run p>O +1 =Watchdog_Disabled disabled:1 total:3 "
      & "+100 =Watchdog_Disabled total:3 @Idle W>O w>E w>E w>E missed:3 =Run "
      & "+1 =Watchdog_Disabled total:3 disabled:1"

      --  Each second for hours: 80 ms early or late in turn
      & "|watchdog, a reload in time forgives: @Idle W>O "
      & 10 * "+5 w>E +12 missed:2 +10 w>O missed:0 " & "=Run total:20 "
      & "@Idle W>O +10 T=32767>O w>O +10 M=100>O w>O +10 =Run w>O T=-32768>O "
      & "+36 =Watchdog_Disabled mark +5 still b>0 @Watchdog_Disabled u>E W>E "
      & "w>E M=0>E T=5>E = r>O =Idle W>O missed:0 +10 w>O @Idle ~50000 W>O "
      & 2_500 * "~920000 w>O ~1080000 w>O " & "total:0 =Run"
      & "|no watchdog, any reload: @Run w>O +1 w>O +8 w>O +9 w>O +11 w>O +12 "
      & "w>O +20 w>O +30 w>O total:0 =Run"

      --  A valid command does, refused or not; an unknown one and a wrong
      --  checksum do not
      & "|what keeps it awake: @Idle p>O +1199 w>E +1199 =Idle x>C pq!E M=>C "
      & "+1 =Off"

      & "|in charge: @Movement mark plugged:True =In_Charge +6000 =In_Charge "
      & "still plugged:False =Idle +1199 =Idle @Idle W>O plugged:True "
      & "watchdog:False +100 =In_Charge @Start_Up plugged:True =In_Charge "
      & "@Off plugged:True =Off"

      & "|power cycle: @Idle W>O M=32767>O +3 battery:Low &half_a_frame mark "
      & "on =Start_Up watchdog:False missed:0 p>O v>1 +16 =Idle still"

      & "|its watchdog disables it: @Idle W>O M=100>O +1 starve "
      & "=Watchdog_Disabled disabled:1 w>E M=0>E r>O =Idle"

      & "|counters: @Idle commands:0 M=0>E u>O M=0>O T=0>O M=1>O x>C M=0x!E "
      & "commands:7 stops:3"

      & "|time: @Idle ~-50000 =Idle last =Off on p>O");
   Run_Test ("unknown letter: C", Test_Unknown'Access);
   Run_Test ("numbers of M and T", Test_Numbers'Access);
   Run_Test ("each command by state", Test_By_State'Access);
   Run_Test ("wheels not ideal", Test_Wheels'Access);
end Robot_Core_Tests;
