--  SPDX-License-Identifier: GPL-3.0-or-later
--  The firmware's state machine, row by row of PROTOCOL.md.

with AUnit.Assertions; use AUnit.Assertions;

with Interfaces;
with Robot_Core;   use Robot_Core;
with Robot_Motion;

package body Robot_Core_Tests is

   use type Robot_Motion.Micro;

   use type Octet;

   subtype Any_Test is AUnit.Test_Cases.Test_Case'Class;

   CR : constant Octet := 16#0D#;

   Result   : Exchange;
   Complete : Boolean;
   --  Of the last frame sent

   --  Talking to a robot

   function Bytes (Text : String) return Octets;
   function Image (Data : Octets) return String;

   procedure Send_Raw (R : in out Robot; Data : Octets);
   --  Data as it is

   function Raw_Answer (R : in out Robot; Data : Octets) return String;
   --  Data and a carriage return; the answer's text, checked to be well
   --  framed, or "" without one

   function Ask (R : in out Robot; Text : String) return String is
     (Raw_Answer (R, Bytes (Text) & Checksum (Bytes (Text))));

   procedure Expect (R : in out Robot; Text, Answer : String);

   procedure Expect_State (R : Robot; State : State_Kind);

   procedure Wait (R : in out Robot; Ticks : Natural);

   procedure Wait_Microseconds (R : in out Robot; Time : Time_Point);

   function In_State (State : State_Kind) return Robot;
   --  A robot that got there in an ordinary way

   --  Tests

   procedure Test_Checksum (T : in out Any_Test);
   procedure Test_Answer_Frames (T : in out Any_Test);
   procedure Test_Bad_Checksum (T : in out Any_Test);
   procedure Test_Checksum_Sent_As_0E (T : in out Any_Test);
   procedure Test_NUL_Dropped (T : in out Any_Test);
   procedure Test_Wrap_At_50 (T : in out Any_Test);
   procedure Test_First_Letter_Counts (T : in out Any_Test);
   procedure Test_Unknown (T : in out Any_Test);
   procedure Test_Every_Byte_String (T : in out Any_Test);
   procedure Test_Numbers (T : in out Any_Test);
   procedure Test_Start_Up_Time (T : in out Any_Test);
   procedure Test_Start_Up_Option (T : in out Any_Test);
   procedure Test_Queries_In_Every_State (T : in out Any_Test);
   procedure Test_Start_Rows (T : in out Any_Test);
   procedure Test_Move_Rows (T : in out Any_Test);
   procedure Test_Reset_Rows (T : in out Any_Test);
   procedure Test_Reload_Rows (T : in out Any_Test);
   procedure Test_Busy (T : in out Any_Test);
   procedure Test_Battery_Levels (T : in out Any_Test);
   procedure Test_Movement_Replaced (T : in out Any_Test);
   procedure Test_Movement_Ends (T : in out Any_Test);
   procedure Test_Window_Edges (T : in out Any_Test);
   procedure Test_Window_Phase (T : in out Any_Test);
   procedure Test_Missed_Returns_To_0 (T : in out Any_Test);
   procedure Test_Three_Misses (T : in out Any_Test);
   procedure Test_Early_Reloads_Disable (T : in out Any_Test);
   procedure Test_Watchdog_While_Moving (T : in out Any_Test);
   procedure Test_Reset_From_Disabled (T : in out Any_Test);
   procedure Test_Watchdog_Off_Reload (T : in out Any_Test);
   procedure Test_Watchdog_Kept_For_Hours (T : in out Any_Test);
   procedure Test_Power_Off_After_2_Minutes (T : in out Any_Test);
   procedure Test_What_Keeps_Awake (T : in out Any_Test);
   procedure Test_Power_Off_Command (T : in out Any_Test);
   procedure Test_Charging (T : in out Any_Test);
   procedure Test_Low_Battery (T : in out Any_Test);
   procedure Test_Power_Cycle (T : in out Any_Test);
   procedure Test_Starve (T : in out Any_Test);
   procedure Test_Wheels (T : in out Any_Test);
   procedure Test_Counters (T : in out Any_Test);
   procedure Test_Time_Goes_One_Way (T : in out Any_Test);

   function Bytes (Text : String) return Octets is
      Data : Octets (1 .. Text'Length);
   begin
      for K in Data'Range loop
         Data (K) := Character'Pos (Text (Text'First + K - 1));
      end loop;
      return Data;
   end Bytes;

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

   function Image (Data : Octets) return String is
      Text : String (1 .. Data'Length);
   begin
      for K in Text'Range loop
         Text (K) := Character'Val (Data (Data'First + K - 1));
      end loop;
      return Text;
   end Image;

   function In_State (State : State_Kind) return Robot is
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
            Set_Battery (R, Critical);
      end case;
      Expect_State (R, State);
      return R;
   end In_State;

   overriding function Name (T : Test_Case) return AUnit.Message_String is
     (AUnit.Format ("Robot_Core"));

   function Raw_Answer (R : in out Robot; Data : Octets) return String is
   begin
      Send_Raw (R, Data);
      Assert (not Complete, "a frame ended before its carriage return");
      Send_Raw (R, (1 => CR));
      Assert (Complete, "no frame at a carriage return");
      if Result.Reply.Length = 0 then
         return "";
      end if;
      declare
         Frame : Octets renames
           Result.Reply.Data (1 .. Result.Reply.Length);
         Text  : Octets renames Frame (1 .. Frame'Last - 2);
      begin
         Assert (Frame (Frame'Last) = CR, "answer without its end");
         Assert (Frame (Frame'Last - 1) = Checksum (Text),
                 "answer with a wrong checksum");
         return Image (Text);
      end;
   end Raw_Answer;

   procedure Send_Raw (R : in out Robot; Data : Octets) is
   begin
      Complete := False;
      for Byte of Data loop
         Receive (R, Byte, Complete, Result);
      end loop;
   end Send_Raw;

   procedure Test_Answer_Frames (T : in out Any_Test) is
      pragma Unreferenced (T);
      R : Robot := In_State (Idle);
   begin
      Send_Raw (R, Bytes ("pp") & CR);
      Assert (Result.Reply.Data (1 .. Result.Reply.Length)
              = Bytes ("OO") & CR, "O");
      Send_Raw (R, Bytes ("ww") & CR);
      Assert (Result.Reply.Data (1 .. Result.Reply.Length)
              = Bytes ("EE") & CR, "E");
      Send_Raw (R, Bytes ("xx") & CR);
      Assert (Result.Reply.Data (1 .. Result.Reply.Length)
              = Bytes ("CC") & CR, "C");
      Send_Raw (R, Bytes ("VV") & CR);
      Assert (Result.Reply.Data (1 .. Result.Reply.Length)
              = Bytes ("3.5") & 16#28# & CR, "version");
   end Test_Answer_Frames;

   procedure Test_Bad_Checksum (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      for State in Start_Up .. State_Kind'Last loop
         declare
            R : Robot := In_State (State);
         begin
            Assert (Raw_Answer (R, Bytes ("pq")) = "E", "wrong checksum");
            Assert (Raw_Answer (R, Bytes ("p")) = "E", "checksum alone");
            Assert (Raw_Answer (R, Bytes ("")) = "E", "empty frame");
            Assert (Raw_Answer (R, Bytes ("xy")) = "E",
                    "unknown letter with a wrong checksum");
            Assert (Raw_Answer (R, Bytes ("zy")) = "E",
                    "power off with a wrong checksum");
            Expect_State (R, State);
         end;
      end loop;
   end Test_Bad_Checksum;

   procedure Test_Battery_Levels (T : in out Any_Test) is
      pragma Unreferenced (T);
      R : Robot := In_State (Movement);
   begin
      Expect (R, "v", "2");
      Set_Battery (R, Low);
      Expect (R, "v", "1");
      Set_Battery (R, Empty);
      Expect (R, "v", "0");
      Expect_State (R, Movement);
      Set_Charging (R, True);
      Expect (R, "v", "0");
      Set_Battery (R, Full);
      Expect (R, "v", "2");
   end Test_Battery_Levels;

   procedure Test_Busy (T : in out Any_Test) is
      pragma Unreferenced (T);
      R : Robot := In_State (Run);
   begin
      Expect (R, "b", "0");
      Expect (R, "M=10", "O");
      Expect (R, "b", "1");
      Expect (R, "M=0", "O");
      Expect (R, "b", "0");
      Expect (R, "T=-20", "O");
      Expect (R, "b", "1");
      Expect (R, "T=0", "O");
      Expect (R, "b", "0");
   end Test_Busy;

   procedure Test_Charging (T : in out Any_Test) is
      pragma Unreferenced (T);
      R : Robot := In_State (Movement);
      Before : Robot_Motion.Pose;
      use type Robot_Motion.Pose;
   begin
      Before := Pose (R);
      Set_Charging (R, True);
      Expect_State (R, In_Charge);
      Wait (R, 5 * Inactivity_Ticks);
      Expect_State (R, In_Charge);
      Assert (Pose (R) = Before, "moved while in charge");
      Set_Charging (R, False);
      Expect_State (R, Idle);
      Wait (R, Inactivity_Ticks - 1);
      Expect_State (R, Idle);

      R := In_State (Idle);
      Expect (R, "W", "O");
      Set_Charging (R, True);
      Assert (not Watchdog_On (R), "watchdog on in charge");
      Wait (R, 100);
      Expect_State (R, In_Charge);

      R := In_State (Start_Up);
      Set_Charging (R, True);
      Expect_State (R, In_Charge);

      R := In_State (Off);
      Set_Charging (R, True);
      Expect_State (R, Off);
   end Test_Charging;

   procedure Test_Checksum (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Assert (Checksum (Bytes ("p")) = 16#70#, "one letter");
      Assert (Checksum (Bytes ("pp")) = 0, "two alike");
      Assert (Checksum (Bytes ("M=0")) = 16#40#, "M=0");
      Assert (Checksum ((16#0C#, 16#01#)) = 16#0E#, "0x0D sent as 0x0E");
      Assert (Checksum (Octets'(1 => CR)) = 16#0E#, "0x0D alone");
      Assert (Checksum ((16#0F#, 16#01#)) = 16#0E#, "0x0E itself");
      Assert (Checksum (Bytes ("")) = 0, "nothing");
   end Test_Checksum;

   procedure Test_Checksum_Sent_As_0E (T : in out Any_Test) is
      pragma Unreferenced (T);
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

   procedure Test_Counters (T : in out Any_Test) is
      pragma Unreferenced (T);
      R : Robot := In_State (Idle);
   begin
      Assert (Commands (R) = 0, "none yet");
      Expect (R, "M=0", "E");
      Expect (R, "u", "O");
      Expect (R, "M=0", "O");
      Expect (R, "T=0", "O");
      Expect (R, "M=1", "O");
      Expect (R, "x", "C");
      Assert (Raw_Answer (R, Bytes ("M=0x")) = "E", "wrong checksum");
      Assert (Commands (R) = 7, "frames" & Commands (R)'Image);
      Assert (Stops (R) = 3, "stops" & Stops (R)'Image);
   end Test_Counters;

   procedure Test_Early_Reloads_Disable (T : in out Any_Test) is
      pragma Unreferenced (T);
      R : Robot := In_State (Idle);
   begin
      Expect (R, "W", "O");
      Expect (R, "w", "E");
      Expect (R, "w", "E");
      Expect (R, "w", "E");
      Assert (Missed (R) = 3, "missed" & Missed (R)'Image);
      Expect_State (R, Run);
      Wait (R, 1);
      Expect_State (R, Watchdog_Disabled);
      Assert (Missed_Total (R) = 3, "in all" & Missed_Total (R)'Image);
      Assert (Disabled_Count (R) = 1, "disabled once");
   end Test_Early_Reloads_Disable;

   procedure Test_Every_Byte_String (T : in out Any_Test) is
      pragma Unreferenced (T);
      R    : Robot := In_State (Run);
      Seed : Interfaces.Unsigned_32 := 12_345;
      use type Interfaces.Unsigned_32;
   begin
      --  Every text of two bytes, every state of the receiver, then a long
      --  random stream: no exception, and the robot is sane afterwards

      for First in Octet loop
         for Second in Octet loop
            Send_Raw (R, (First, Second, First xor Second, CR));
         end loop;
         Switch_On (R, 1);
         Wait (R, 1);
         Expect (R, "u", "O");
      end loop;

      for K in 1 .. 200_000 loop
         Seed := Seed * 1_664_525 + 1_013_904_223;
         Receive (R, Octet (Interfaces.Shift_Right (Seed, 24)), Complete,
                  Result);
      end loop;
      Send_Raw (R, (1 => CR));
      Switch_On (R);
      Expect (R, "p", "O");
   end Test_Every_Byte_String;

   procedure Test_First_Letter_Counts (T : in out Any_Test) is
      pragma Unreferenced (T);
      R : Robot := In_State (Idle);
   begin
      Expect (R, "ping", "O");
      Expect (R, "p?", "O");
      Expect (R, "battery", "0");
      Expect (R, "voltage", "2");
      Expect (R, "Version", "3.5");
      Expect (R, "u and away", "O");
      Expect_State (R, Run);
      Expect (R, "reset", "O");
      Expect_State (R, Idle);
      Expect (R, "Watchdog", "O");
      Assert (Watchdog_On (R), "watchdog");
   end Test_First_Letter_Counts;

   procedure Test_Low_Battery (T : in out Any_Test) is
      pragma Unreferenced (T);
      R : Robot := In_State (Idle);
      Before : Robot_Motion.Pose;
      use type Robot_Motion.Pose;
   begin
      Expect (R, "W", "O");
      Expect (R, "M=32767", "O");
      Wait (R, 5);
      Set_Battery (R, Critical);
      Expect_State (R, Low_Battery);
      Assert (not Watchdog_On (R), "watchdog on");
      Expect (R, "b", "0");
      Before := Pose (R);
      Wait (R, Low_Battery_Ticks - 1);
      Expect_State (R, Low_Battery);
      Assert (Pose (R) = Before, "moved");
      Wait (R, 1);
      Expect_State (R, Off);
      Expect (R, "p", "");

      --  Switched on again it finds its battery as bad

      Switch_On (R);
      Expect_State (R, Low_Battery);

      --  A charger saves it; a better reading alone does not

      Set_Battery (R, Full);
      Expect_State (R, Low_Battery);
      Set_Charging (R, True);
      Expect_State (R, In_Charge);
      Set_Charging (R, False);
      Expect_State (R, Idle);

      R := In_State (In_Charge);
      Set_Battery (R, Critical);
      Expect_State (R, In_Charge);
      Set_Charging (R, False);
      Expect_State (R, Low_Battery);
   end Test_Low_Battery;

   procedure Test_Missed_Returns_To_0 (T : in out Any_Test) is
      pragma Unreferenced (T);
      R : Robot := In_State (Idle);
   begin
      Expect (R, "W", "O");
      for Round in 1 .. 10 loop
         Wait (R, 5);
         Expect (R, "w", "E");
         Wait (R, 12);
         Assert (Missed (R) = 2, "one refused, one missed");
         Wait (R, 10);
         Expect (R, "w", "O");
         Assert (Missed (R) = 0, "forgiven");
      end loop;
      Expect_State (R, Run);
      Assert (Missed_Total (R) = 20, "in all" & Missed_Total (R)'Image);
   end Test_Missed_Returns_To_0;

   procedure Test_Move_Rows (T : in out Any_Test) is
      pragma Unreferenced (T);

      procedure Try (Text : String; Stop : Boolean);

      procedure Try (Text : String; Stop : Boolean) is
      begin
         for State in Start_Up .. State_Kind'Last loop
            declare
               R : Robot := In_State (State);
            begin
               if State in Run | Movement then
                  Expect (R, Text, "O");
                  Expect_State (R, (if Stop then Run else Movement));
               else
                  Expect (R, Text, "E");
                  Expect_State (R, State);
               end if;
            end;
         end loop;
      end Try;

   begin
      Try ("M=100", Stop => False);
      Try ("M=-100", Stop => False);
      Try ("M=32767", Stop => False);
      Try ("M=-32768", Stop => False);
      Try ("T=90", Stop => False);
      Try ("T=-90", Stop => False);
      Try ("T=32767", Stop => False);
      Try ("T=-32768", Stop => False);
      Try ("M=0", Stop => True);
      Try ("T=0", Stop => True);
   end Test_Move_Rows;

   procedure Test_Movement_Ends (T : in out Any_Test) is
      pragma Unreferenced (T);
      R : Robot := In_State (Run);
   begin
      --  100 mm at 200 mm/s: 500 ms

      Expect (R, "M=100", "O");
      Wait_Microseconds (R, 499_999);
      Expect_State (R, Movement);
      Wait_Microseconds (R, 1);
      Expect_State (R, Run);
      Expect (R, "b", "0");

      --  90 degrees at 90 degrees/s: 1 s

      Expect (R, "T=-90", "O");
      Wait_Microseconds (R, 999_999);
      Expect_State (R, Movement);
      Wait_Microseconds (R, 1);
      Expect_State (R, Run);

      --  Endless ones do not end, not even against a wall

      Expect (R, "M=-32768", "O");
      for K in 1 .. 100 loop
         Wait (R, 100);
         Expect (R, "p", "O");
      end loop;
      Expect_State (R, Movement);
   end Test_Movement_Ends;

   procedure Test_Movement_Replaced (T : in out Any_Test) is
      pragma Unreferenced (T);
      R : Robot := In_State (Run);
      A : Robot_Motion.Pose;
   begin
      Expect (R, "M=32767", "O");
      Wait (R, 5);
      A := Pose (R);
      Assert (A.X = 500_000, "100 mm in 500 ms");
      Expect (R, "T=32767", "O");
      Wait (R, 10);
      Assert (Pose (R).X = A.X, "turns on the spot");
      Assert (Pose (R).Angle = 90_000_000, "90 degrees to the left");
      Expect (R, "M=50", "O");
      Wait_Microseconds (R, 250_000);
      Expect_State (R, Run);
      Assert (Pose (R).Y = 350_000, "50 mm upwards");
      Expect_State (R, Run);
   end Test_Movement_Replaced;

   procedure Test_NUL_Dropped (T : in out Any_Test) is
      pragma Unreferenced (T);
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
      Assert (Raw_Answer (R, (16#61#, 16#11#, 16#70#, 0)) = "C",
              "'a', and 0x70 taken for the checksum");
      Assert (Raw_Answer (R, (16#70#, 16#62#, 16#61#, 16#73#, 0)) = "O",
              "'p', and 0x73 taken for the checksum");
   end Test_NUL_Dropped;

   procedure Test_Numbers (T : in out Any_Test) is
      pragma Unreferenced (T);
      R : Robot := In_State (Run);

      procedure Accepts (Number : String; Value : Integer);

      procedure Refuses (Text : String);

      procedure Accepts (Number : String; Value : Integer) is
      begin
         Expect (R, "M=" & Number, "O");
         Assert (Result.Kind = Move and then Result.Amount = Value,
                 "M=" & Number & " read as" & Result.Amount'Image);
         Expect (R, "T=" & Number, "O");
         Assert (Result.Kind = Turn and then Result.Amount = Value,
                 "T=" & Number & " read as" & Result.Amount'Image);
      end Accepts;

      procedure Refuses (Text : String) is
      begin
         Expect (R, "M=0", "O");
         Expect (R, Text, "C");
         Expect_State (R, Run);
      end Refuses;

   begin
      Accepts ("0", 0);
      Accepts ("1", 1);
      Accepts ("-1", -1);
      Accepts ("+7", 7);
      Accepts ("  42", 42);
      Accepts ("0000000000000000000000000123", 123);
      Accepts ("12abc", 12);
      Accepts ("12 34", 12);
      Accepts ("1-2", 1);
      Accepts ("32766", 32_766);
      Accepts ("32767", 32_767);
      Accepts ("32768", 32_767);
      Accepts ("99999999999999999999999999999", 32_767);
      Accepts ("-32767", -32_767);
      Accepts ("-32768", -32_768);
      Accepts ("-32769", -32_768);
      Accepts ("-99999999999999999999999999999", -32_768);

      for Letter in Character range 'M' .. 'T' loop
         if Letter in 'M' | 'T' then
            Refuses ((1 => Letter));
            Refuses (Letter & "=");
            Refuses (Letter & "=-");
            Refuses (Letter & "=+");
            Refuses (Letter & "=- 1");
            Refuses (Letter & "=+-1");
            Refuses (Letter & "=x");
            Refuses (Letter & "= ");
            Refuses (Letter & "12");
            Refuses (Letter & " =12");
            Refuses (Letter & ":12");
         end if;
      end loop;
   end Test_Numbers;

   procedure Test_Power_Cycle (T : in out Any_Test) is
      pragma Unreferenced (T);
      R : Robot := In_State (Idle);
      A : Robot_Motion.Pose;
      use type Robot_Motion.Pose;
   begin
      Expect (R, "W", "O");
      Expect (R, "M=32767", "O");
      Wait (R, 3);
      Set_Battery (R, Low);
      A := Pose (R);
      Send_Raw (R, Bytes ("half a fra"));
      Switch_On (R);
      Expect_State (R, Start_Up);
      Assert (not Watchdog_On (R) and then Missed (R) = 0, "watchdog");
      Expect (R, "p", "O");
      Expect (R, "v", "1");
      Wait (R, Boot_Ticks);
      Expect_State (R, Idle);
      Assert (Pose (R) = A, "moved");
   end Test_Power_Cycle;

   procedure Test_Power_Off_After_2_Minutes (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      for State in Idle .. State_Kind'Last loop
         if State not in In_Charge | Low_Battery then
            declare
               R : Robot := In_State (State);
            begin
               Expect (R, "p", "O");
               Wait_Microseconds (R, 120_000_000 - 1);
               Expect_State (R, State);
               Wait_Microseconds (R, 1);
               Expect_State (R, Off);
               Expect (R, "p", "");
               Expect_State (R, Off);
            end;
         end if;
      end loop;
   end Test_Power_Off_After_2_Minutes;

   procedure Test_Power_Off_Command (T : in out Any_Test) is
      pragma Unreferenced (T);
      use type Robot_Motion.Pose;
   begin
      for State in Start_Up .. State_Kind'Last loop
         declare
            R : Robot := In_State (State);
            A : Robot_Motion.Pose;
         begin
            Expect (R, "z", "O");
            Expect_State (R, Off);
            A := Pose (R);
            Wait (R, 20);
            Assert (Pose (R) = A, "moved while off");
            Expect (R, "p", "");
            Expect (R, "u", "");
            Expect (R, "x", "");
            Assert (Raw_Answer (R, Bytes ("pq")) = "", "bad checksum");
            Expect_State (R, Off);
            Assert (not Watchdog_On (R), "watchdog on");
         end;
      end loop;
   end Test_Power_Off_Command;

   procedure Test_Queries_In_Every_State (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      for State in Start_Up .. State_Kind'Last loop
         declare
            R : Robot := In_State (State);
         begin
            Expect (R, "p", "O");
            Expect (R, "v", (if State = Low_Battery then "0" else "2"));
            Expect (R, "b", (if State = Movement then "1" else "0"));
            Expect (R, "V", "3.5");
            Expect_State (R, State);
         end;
      end loop;
   end Test_Queries_In_Every_State;

   procedure Test_Reload_Rows (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      for State in Start_Up .. State_Kind'Last loop
         declare
            R : Robot := In_State (State);
         begin
            Expect (R, "w", (if State in Run | Movement then "O" else "E"));
            Expect_State (R, State);
         end;
      end loop;
   end Test_Reload_Rows;

   procedure Test_Starve (T : in out Any_Test) is
      pragma Unreferenced (T);
      R : Robot;
   begin
      for State in State_Kind loop
         R := In_State (State);
         Starve (R);
         Expect_State (R, State);
      end loop;

      R := In_State (Idle);
      Expect (R, "W", "O");
      Expect (R, "M=100", "O");
      Wait (R, 1);
      Starve (R);
      Expect_State (R, Watchdog_Disabled);
      Assert (Disabled_Count (R) = 1, "counted");
      Expect (R, "w", "E");
      Expect (R, "M=0", "E");
      Expect (R, "r", "O");
      Expect_State (R, Idle);
   end Test_Starve;

   procedure Test_Reset_From_Disabled (T : in out Any_Test) is
      pragma Unreferenced (T);
      R : Robot := In_State (Watchdog_Disabled);
   begin
      Expect (R, "u", "E");
      Expect (R, "W", "E");
      Expect (R, "w", "E");
      Expect (R, "M=0", "E");
      Expect (R, "T=5", "E");
      Expect_State (R, Watchdog_Disabled);
      Expect (R, "r", "O");
      Expect_State (R, Idle);
      Expect (R, "W", "O");
      Assert (Missed (R) = 0, "old misses count again");
      Wait (R, 10);
      Expect (R, "w", "O");
   end Test_Reset_From_Disabled;

   procedure Test_Reset_Rows (T : in out Any_Test) is
      pragma Unreferenced (T);
      use type Robot_Motion.Pose;
   begin
      for State in Start_Up .. State_Kind'Last loop
         declare
            R : Robot := In_State (State);
            A : Robot_Motion.Pose;
         begin
            if State in Idle | Run | Movement | Watchdog_Disabled then
               Expect (R, "r", "O");
               Expect_State (R, Idle);
               Assert (not Watchdog_On (R), "watchdog on");
               A := Pose (R);
               Wait (R, 5);
               Assert (Pose (R) = A, "motors not stopped");
            else
               Expect (R, "r", "E");
               Expect_State (R, State);
            end if;
         end;
      end loop;
   end Test_Reset_Rows;

   procedure Test_Start_Rows (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      for Watchdog in Boolean loop
         for State in Start_Up .. State_Kind'Last loop
            declare
               R    : Robot := In_State (State);
               Text : constant String := (if Watchdog then "W" else "u");
            begin
               if State = Idle then
                  Expect (R, Text, "O");
                  Expect_State (R, Run);
                  Assert (Watchdog_On (R) = Watchdog, "watchdog");
                  Assert (Missed (R) = 0, "missed");
               else
                  Expect (R, Text, "E");
                  Expect_State (R, State);
                  Assert (not Watchdog_On (R), "watchdog");
               end if;
            end;
         end loop;
      end loop;
   end Test_Start_Rows;

   procedure Test_Start_Up_Option (T : in out Any_Test) is
      pragma Unreferenced (T);
      R : Robot;
   begin
      Switch_On (R, Boot => 30);
      Wait_Microseconds (R, 2_999_999);
      Expect_State (R, Start_Up);
      Wait_Microseconds (R, 1);
      Expect_State (R, Idle);
   end Test_Start_Up_Option;

   procedure Test_Start_Up_Time (T : in out Any_Test) is
      pragma Unreferenced (T);
      R : Robot;
   begin
      Expect_State (R, Off);
      Expect (R, "p", "");
      Wait_Microseconds (R, 777_777);
      Switch_On (R);
      Expect_State (R, Start_Up);
      Wait_Microseconds (R, 1_599_999);
      Expect_State (R, Start_Up);
      Expect (R, "u", "E");
      Wait_Microseconds (R, 1);
      Expect_State (R, Idle);
      Expect (R, "u", "O");
   end Test_Start_Up_Time;

   procedure Test_Three_Misses (T : in out Any_Test) is
      pragma Unreferenced (T);
      R : Robot := In_State (Idle);
   begin
      Expect (R, "W", "O");
      Wait (R, 11);
      Assert (Missed (R) = 0, "11 ticks are not a miss");
      Wait (R, 1);
      Assert (Missed (R) = 1, "12 are");
      Wait (R, 11);
      Assert (Missed (R) = 1, "the counter restarts");
      Wait (R, 1);
      Assert (Missed (R) = 2, "second");
      Wait (R, 11);
      Expect_State (R, Run);
      Expect (R, "p", "O");
      Wait (R, 1);
      Expect_State (R, Watchdog_Disabled);
      Assert (Disabled_Count (R) = 1, "once");
      Assert (Missed_Total (R) = 3, "three");
      Wait (R, 100);
      Expect_State (R, Watchdog_Disabled);
      Assert (Missed_Total (R) = 3, "goes on counting");
   end Test_Three_Misses;

   procedure Test_Time_Goes_One_Way (T : in out Any_Test) is
      pragma Unreferenced (T);
      R : Robot := In_State (Idle);
      Then_Now : constant Time_Point := Clock (R);
   begin
      Advance_To (R, Then_Now - 50_000);
      Assert (Clock (R) = Then_Now, "went back");
      Advance_To (R, Time_Point'Last);
      Expect_State (R, Off);
      Assert (Clock (R) = Time_Point'Last, "the end of time");
      Switch_On (R);
      Expect (R, "p", "O");
   end Test_Time_Goes_One_Way;

   procedure Test_Unknown (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      for State in Start_Up .. State_Kind'Last loop
         declare
            R : Robot := In_State (State);
         begin
            for Code in Octet range 1 .. 255 loop
               if Character'Val (Code)
                 not in 'p' | 'r' | 'u' | 'W' | 'w' | 'v' | 'b' | 'V' | 'z'
                 and then Code /= CR
               then
                  Expect (R, (1 => Character'Val (Code)), "C");
               end if;
            end loop;
            Expect_State (R, State);
         end;
      end loop;
   end Test_Unknown;

   procedure Test_Watchdog_Kept_For_Hours (T : in out Any_Test) is
      pragma Unreferenced (T);
      R : Robot := In_State (Idle);
   begin
      --  Every second, 80 ms early or late in turn: 10 ticks, or one more
      --  or less

      Wait_Microseconds (R, 50_000);
      Expect (R, "W", "O");
      for K in 1 .. 5_000 loop
         Wait_Microseconds
           (R, (if K mod 2 = 0 then 1_080_000 else 920_000));
         Expect (R, "w", "O");
      end loop;
      Assert (Missed_Total (R) = 0, "missed" & Missed_Total (R)'Image);
      Expect_State (R, Run);
   end Test_Watchdog_Kept_For_Hours;

   procedure Test_Watchdog_Off_Reload (T : in out Any_Test) is
      pragma Unreferenced (T);
      R : Robot := In_State (Run);
   begin
      for K in 1 .. 20 loop
         Expect (R, "w", "O");
         Wait (R, K);
      end loop;
      Expect_State (R, Run);
      Assert (Missed_Total (R) = 0, "missed");
   end Test_Watchdog_Off_Reload;

   procedure Test_Watchdog_While_Moving (T : in out Any_Test) is
      pragma Unreferenced (T);
      R : Robot := In_State (Idle);
      A : Robot_Motion.Pose;
      use type Robot_Motion.Pose;
   begin
      Expect (R, "W", "O");
      Wait (R, 10);
      Expect (R, "T=32767", "O");
      Expect (R, "w", "O");
      Wait (R, 10);
      Expect (R, "M=100", "O");
      Expect (R, "w", "O");
      Wait (R, 10);
      Expect_State (R, Run);
      Expect (R, "w", "O");
      Expect (R, "T=-32768", "O");
      Wait (R, 36);
      Expect_State (R, Watchdog_Disabled);
      A := Pose (R);
      Wait (R, 5);
      Assert (Pose (R) = A, "motors not stopped");
      Expect (R, "b", "0");
   end Test_Watchdog_While_Moving;

   procedure Test_What_Keeps_Awake (T : in out Any_Test) is
      pragma Unreferenced (T);
      R : Robot := In_State (Idle);
   begin
      --  A valid command does, refused or not

      Expect (R, "p", "O");
      Wait (R, Inactivity_Ticks - 1);
      Expect (R, "w", "E");
      Wait (R, Inactivity_Ticks - 1);
      Expect_State (R, Idle);

      --  An unknown one and a wrong checksum do not

      Expect (R, "x", "C");
      Assert (Raw_Answer (R, Bytes ("pq")) = "E", "checksum");
      Expect (R, "M=", "C");
      Wait (R, 1);
      Expect_State (R, Off);
   end Test_What_Keeps_Awake;

   procedure Test_Window_Edges (T : in out Any_Test) is
      pragma Unreferenced (T);

      procedure Try (Ticks : Natural; Answer : String; Misses : Natural);

      procedure Try (Ticks : Natural; Answer : String; Misses : Natural) is
         R : Robot := In_State (Idle);
      begin
         --  After the start ...

         Expect (R, "W", "O");
         Wait (R, Ticks);
         Expect (R, "w", Answer);
         Assert (Missed (R) = Misses,
                 Ticks'Image & " ticks:" & Missed (R)'Image & " missed");
         if Ticks <= Watchdog_Last then
            Assert (Result.Ticks = Ticks, "ticks" & Result.Ticks'Image);
         end if;

         --  ... and after a reload, whether accepted or refused

         Wait (R, 10);
         Expect (R, "w", "O");
         Assert (Missed (R) = 0, "not forgiven");
         Wait (R, Ticks);
         Expect (R, "w", Answer);
         Assert (Missed (R) = Misses, "after a reload");
         Expect_State (R, Run);
      end Try;

   begin
      Try (0, "E", 1);
      Try (1, "E", 1);
      Try (8, "E", 1);
      Try (9, "O", 0);
      Try (10, "O", 0);
      Try (11, "O", 0);
      Try (12, "E", 2);  --  missed by the tick, then refused as too early
   end Test_Window_Edges;

   procedure Test_Window_Phase (T : in out Any_Test) is
      pragma Unreferenced (T);

      procedure Try (Offset, Interval : Time_Point; Answer : String);

      procedure Try (Offset, Interval : Time_Point; Answer : String) is
         R : Robot := In_State (Idle);
      begin
         Wait_Microseconds (R, Offset);
         Expect (R, "W", "O");
         Wait_Microseconds (R, Interval);
         Expect (R, "w", Answer);
      end Try;

   begin
      --  The ticks run on from power on: what counts is how many of them
      --  fell between start and reload

      Try (Offset => 10_000, Interval => 889_999, Answer => "E");
      Try (Offset => 10_000, Interval => 890_000, Answer => "O");
      Try (Offset => 90_000, Interval => 809_999, Answer => "E");
      Try (Offset => 90_000, Interval => 810_000, Answer => "O");
      Try (Offset => 10_000, Interval => 1_189_999, Answer => "O");
      Try (Offset => 10_000, Interval => 1_190_000, Answer => "E");
      Try (Offset => 90_000, Interval => 1_109_999, Answer => "O");
      Try (Offset => 90_000, Interval => 1_110_000, Answer => "E");
   end Test_Window_Phase;

   procedure Test_Wrap_At_50 (T : in out Any_Test) is
      pragma Unreferenced (T);
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

   procedure Wait (R : in out Robot; Ticks : Natural) is
   begin
      Wait_Microseconds (R, Time_Point (Ticks) * Tick);
   end Wait;

   procedure Wait_Microseconds (R : in out Robot; Time : Time_Point) is
   begin
      Advance_To (R, Clock (R) + Time);
   end Wait_Microseconds;

   procedure Test_Wheels (T : in out Any_Test) is
      pragma Unreferenced (T);
      use type Robot_Motion.Pose;
      R : Robot := In_State (Run);
   begin
      --  From the next order on, each as long as it takes; a power cycle
      --  mends nothing

      Expect (R, "M=200", "O");
      Wait (R, 5);
      Set_Wheels (R, (Speed      => 70,
                      Turn_Speed => 130,
                      Overshoot  => 20,
                      Pull       => 10));
      Wait (R, 5);
      Expect (R, "b", "0");
      Assert (Pose (R) = (600_000, 300_000, 0), "the order under way");
      Expect (R, "M=-200", "O");
      Wait_Microseconds (R, 999_999);
      Expect (R, "b", "1");
      Wait_Microseconds (R, 1);
      Expect (R, "b", "0");
      Assert (Pose (R).Angle = 358_600_000
              and then Pose (R).X in 460_000 .. 460_100
              and then Pose (R).Y in 301_600 .. 301_800, "an arc, slowly");

      Switch_On (R);
      Wait (R, Boot_Ticks);
      Expect (R, "u", "O");
      Expect (R, "T=90", "O");
      Wait_Microseconds (R, 1_199_999);
      Expect (R, "b", "1");
      Wait_Microseconds (R, 1);
      Expect (R, "b", "0");
      Assert (Pose (R).Angle = 358_600_000 + 140_400_000 - 360_000_000,
              "a turn too fast and too long");

      Set_Wheels (R, Robot_Motion.Ideal);
      Expect (R, "T=-139", "O");
      Wait (R, 16);
      Assert (Pose (R).Angle = 0, "ideal again");
   end Test_Wheels;

   overriding procedure Register_Tests (T : in out Test_Case) is
      use AUnit.Test_Cases.Registration;
   begin
      Register_Routine (T, Test_Checksum'Access, "checksum");
      Register_Routine (T, Test_Answer_Frames'Access, "answer frames");
      Register_Routine (T, Test_Bad_Checksum'Access, "bad checksum: E");
      Register_Routine
        (T, Test_Checksum_Sent_As_0E'Access, "checksum 0x0D sent as 0x0E");
      Register_Routine (T, Test_NUL_Dropped'Access, "NUL dropped");
      Register_Routine (T, Test_Wrap_At_50'Access, "wrap at 50 bytes");
      Register_Routine
        (T, Test_First_Letter_Counts'Access, "only the first letter counts");
      Register_Routine (T, Test_Unknown'Access, "unknown letter: C");
      Register_Routine (T, Test_Every_Byte_String'Access, "any bytes");
      Register_Routine (T, Test_Numbers'Access, "numbers of M and T");
      Register_Routine (T, Test_Start_Up_Time'Access, "start-up, 1.6 s");
      Register_Routine (T, Test_Start_Up_Option'Access, "start-up, 3 s");
      Register_Routine
        (T, Test_Queries_In_Every_State'Access, "queries in every state");
      Register_Routine (T, Test_Start_Rows'Access, "u and W by state");
      Register_Routine (T, Test_Move_Rows'Access, "M and T by state");
      Register_Routine (T, Test_Reset_Rows'Access, "r by state");
      Register_Routine (T, Test_Reload_Rows'Access, "w by state");
      Register_Routine (T, Test_Busy'Access, "busy");
      Register_Routine (T, Test_Battery_Levels'Access, "battery levels");
      Register_Routine
        (T, Test_Movement_Replaced'Access, "movement replaced");
      Register_Routine (T, Test_Movement_Ends'Access, "movement ends");
      Register_Routine
        (T, Test_Window_Edges'Access, "watchdog window: 8, 9, 11, 12 ticks");
      Register_Routine
        (T, Test_Window_Phase'Access, "watchdog window: phase of the ticks");
      Register_Routine
        (T, Test_Missed_Returns_To_0'Access, "missed count returns to 0");
      Register_Routine (T, Test_Three_Misses'Access, "three misses");
      Register_Routine
        (T, Test_Early_Reloads_Disable'Access, "early reloads disable");
      Register_Routine
        (T, Test_Watchdog_While_Moving'Access, "watchdog while moving");
      Register_Routine
        (T, Test_Reset_From_Disabled'Access, "reset from disabled");
      Register_Routine
        (T, Test_Watchdog_Off_Reload'Access, "reload, watchdog off");
      Register_Routine
        (T, Test_Watchdog_Kept_For_Hours'Access, "watchdog kept for hours");
      Register_Routine
        (T, Test_Power_Off_After_2_Minutes'Access, "off after 2 minutes");
      Register_Routine
        (T, Test_What_Keeps_Awake'Access, "what keeps it awake");
      Register_Routine (T, Test_Power_Off_Command'Access, "power off");
      Register_Routine (T, Test_Charging'Access, "in charge");
      Register_Routine (T, Test_Low_Battery'Access, "low battery");
      Register_Routine (T, Test_Power_Cycle'Access, "power cycle");
      Register_Routine (T, Test_Starve'Access, "its watchdog disables it");
      Register_Routine (T, Test_Wheels'Access, "wheels not ideal");
      Register_Routine (T, Test_Counters'Access, "counters");
      Register_Routine (T, Test_Time_Goes_One_Way'Access, "time");
   end Register_Tests;

end Robot_Core_Tests;
