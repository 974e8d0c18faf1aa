--  SPDX-License-Identifier: GPL-3.0-or-later
--  The firmware's state machine: one procedure a cause (a byte, a tick, the
--  battery), and one that enters a state.

package body Robot_Core with SPARK_Mode is

   NUL             : constant Octet := 16#00#;
   Carriage_Return : constant Octet := 16#0D#;

   procedure Add_One (Counter : in out Natural)
     with Post => Counter >= Counter'Old
   is
      --  Stays at the largest value
   begin
      if Counter < Natural'Last then
         Counter := Counter + 1;
      end if;
   end Add_One;

   procedure Enter (R : in out Robot; State : State_Kind)
     with Post => Robot_Core.State (R) = State
                  and then R.Now = R.Now'Old
                  and then R.Next_Tick = R.Next_Tick'Old
                  and then R.Voltage = R.Voltage'Old
                  and then R.Plugged = R.Plugged'Old
                  and then (if State in Run | Movement
                            then R.Guarded = R.Guarded'Old
                            else not R.Guarded)
   is
      --  Every change of state goes through here: only in movement do the
      --  wheels turn, only in run and movement is the watchdog on
   begin
      if State /= Movement then
         Robot_Motion.Halt (R.Motion);
      end if;
      if State not in Run | Movement then
         R.Guarded := False;
      end if;
      case State is
         when Idle =>
            R.Inactive := 0;
         when Low_Battery =>
            R.Low_Left := Low_Battery_Ticks;
         when others =>
            null;
      end case;
      R.State := State;
   end Enter;

   procedure Follow_Power (R : in out Robot)
     with Post => R.Now = R.Now'Old
                  and then R.Next_Tick = R.Next_Tick'Old
                  and then R.Voltage = R.Voltage'Old
                  and then R.Plugged = R.Plugged'Old
                  and then
                    (if not R.Guarded'Old then not R.Guarded)
                  and then
                    (if R.State'Old = Start_Up
                     then R.State in Start_Up | In_Charge | Low_Battery)
   is
      --  Enters and leaves the states that charger and battery decide
   begin
      if R.State in Off | Low_Battery then
         return;
      elsif R.Plugged then
         if R.State /= In_Charge then
            Enter (R, In_Charge);
         end if;
      elsif Battery (R) = Critical then
         Enter (R, Low_Battery);
      elsif R.State = In_Charge then
         Enter (R, Idle);
      end if;
   end Follow_Power;

   procedure Do_Tick (R : in out Robot)
     with Pre  => R.State /= Off,
          Post => R.Now = R.Now'Old
                  and then R.Next_Tick = R.Next_Tick'Old
   is
   begin
      if R.State = Start_Up then
         if R.Boot_Left > 1 then
            R.Boot_Left := R.Boot_Left - 1;
         else
            Enter (R, Idle);
         end if;
      end if;

      if R.State = Low_Battery then
         if R.Low_Left > 1 then
            R.Low_Left := R.Low_Left - 1;
         else
            Enter (R, Off);
            return;
         end if;
      end if;

      if R.State /= In_Charge then
         if R.Inactive < Inactivity_Ticks - 1 then
            R.Inactive := R.Inactive + 1;
         else
            Enter (R, Off);
            return;
         end if;
      end if;

      if R.Guarded then
         if R.Since_Reload < Watchdog_Last then
            R.Since_Reload := R.Since_Reload + 1;
         else
            R.Since_Reload := 0;
            Add_One (R.Misses);
            Add_One (R.Missed_Sum);
         end if;
         if R.Misses > Misses_Allowed then
            Add_One (R.Disabled_Sum);
            Enter (R, Watchdog_Disabled);
         end if;
      end if;
   end Do_Tick;

   procedure Read_Number
     (Text   : Octets;
      Found  : out Boolean;
      Number : out Robot_Motion.Amount)
   with Pre => Text'First = 1 and then Text'Last <= Max_Frame
   is
      --  As strtol reads: blanks, a sign, digits, and the rest does not
      --  matter. Found: there was a digit.
      subtype Blank is Octet
        with Static_Predicate => Blank in 16#09# .. 16#0C# | 16#20#;
      subtype Digit is Octet
        range Character'Pos ('0') .. Character'Pos ('9');

      Ceiling  : constant := 100_000;
      --  Beyond every limit: more digits change nothing

      Value    : Natural := 0;
      Negative : Boolean := False;
      Next     : Positive := 1;
   begin
      Found := False;

      while Next <= Text'Last and then Text (Next) in Blank loop
         Next := Next + 1;
         pragma Loop_Invariant (Next <= Text'Last + 1);
         pragma Loop_Variant (Increases => Next);
      end loop;

      if Next <= Text'Last
        and then (Text (Next) = Character'Pos ('-')
                  or else Text (Next) = Character'Pos ('+'))
      then
         Negative := Text (Next) = Character'Pos ('-');
         Next := Next + 1;
      end if;

      while Next <= Text'Last and then Text (Next) in Digit loop
         Found := True;
         Value := Natural'Min
           (Ceiling,
            Value * 10 + Natural (Text (Next) - Digit'First));
         Next := Next + 1;
         pragma Loop_Invariant (Value <= Ceiling);
         pragma Loop_Invariant (Next <= Text'Last + 1);
         pragma Loop_Variant (Increases => Next);
      end loop;

      Number :=
        (if Negative then Integer'Max (-Value, Robot_Motion.Amount'First)
         else Integer'Min (Value, Robot_Motion.Amount'Last));
   end Read_Number;

   procedure Decode
     (Command : Frame;
      Kind    : out Command_Kind;
      Amount  : out Robot_Motion.Amount)
   is
      Length : constant Integer := Command.Length - 1;
      --  Of the text, without its checksum
      Found  : Boolean;
   begin
      Kind   := Unknown;
      Amount := 0;

      if Length < 0
        or else Checksum (Command.Data (1 .. Length))
                /= Command.Data (Length + 1)
      then
         Kind := Bad_Checksum;
         return;
      end if;

      --  A frame of one byte cannot get here: its checksum would be a NUL,
      --  which is never received

      if Length = 0 then
         return;
      end if;

      case Character'Val (Command.Data (1)) is
         when 'p' | 't' | 'a' =>
            Kind := Ping;
         when 'r' =>
            Kind := Reset;
         when 'u' =>
            Kind := Start;
         when 'W' =>
            Kind := Start_With_Watchdog;
         when 'w' =>
            Kind := Reload;
         when 'v' =>
            Kind := Get_Battery;
         when 'b' =>
            Kind := Get_Busy;
         when 'V' =>
            Kind := Get_Version;
         when 'z' =>
            Kind := Power_Off;
         when 'M' | 'T' =>
            if Length >= 3 and then Command.Data (2) = Character'Pos ('=')
            then
               declare
                  Digit : constant Octets (1 .. Length - 2) :=
                    Command.Data (3 .. Length);
               begin
                  Read_Number (Digit, Found, Amount);
               end;
               if Found then
                  Kind := (if Command.Data (1) = Character'Pos ('M')
                           then Move else Turn);
               end if;
            end if;
         when others =>
            null;
      end case;
   end Decode;

   function Framed (Text : Octets) return Answer
     with Pre  => Text'Length in 1 .. Answer_Length'Last - 2
                  and then Text'First = 1,
          Post => Framed'Result.Length = Text'Length + 2
   is
      Result : Answer;
   begin
      Result.Length := Text'Length + 2;
      Result.Data (1 .. Text'Length) := Text;
      Result.Data (Text'Length + 1) := Checksum (Text);
      Result.Data (Text'Length + 2) := Carriage_Return;
      return Result;
   end Framed;

   function Framed (Letter : Character) return Answer is
     (Framed (Octets'(1 => Character'Pos (Letter))))
     with Post => Framed'Result.Length = 3;

   procedure Obey (R : in out Robot; Result : in out Exchange)
     with Pre  => R.State not in Off | Low_Battery
                  and then Result.Before = R.State,
          Post => Result.Reply.Length /= 0
                  and then Result.Before = Result.Before'Old
   is
      Accepted : Boolean := True;
   begin
      case Result.Kind is
         when Bad_Checksum =>
            Result.Reply := Framed ('E');
            return;

         when Unknown =>
            Result.Reply := Framed ('C');
            return;

         when others =>
            R.Inactive := 0;
      end case;

      case Valid_Command (Result.Kind) is
         when Ping =>
            null;

         when Get_Battery =>
            Result.Reply := Framed
              (case Battery (R) is
                  when Critical | Empty => '0',
                  when Low              => '1',
                  when Full             => '2');
            return;

         when Get_Busy =>
            Result.Reply := Framed (if R.State = Movement then '1' else '0');
            return;

         when Get_Version =>
            Result.Reply := Framed
              ((Character'Pos ('3'), Character'Pos ('.'),
                Character'Pos ('5')));
            return;

         when Power_Off =>
            Enter (R, Off);

         when Reset =>
            if R.State in Idle | Run | Movement | Watchdog_Disabled then
               Enter (R, Idle);
            else
               Accepted := False;
            end if;

         when Start | Start_With_Watchdog =>
            if R.State = Idle then
               Enter (R, Run);
               if Result.Kind = Start_With_Watchdog then
                  R.Guarded      := True;
                  R.Since_Reload := 0;
                  R.Misses       := 0;
               end if;
            else
               Accepted := False;
            end if;

         when Reload =>
            if R.State not in Run | Movement then
               Accepted := False;
            else
               if R.Guarded then
                  Result.Ticks := R.Since_Reload;
                  Accepted :=
                    R.Since_Reload in Watchdog_First .. Watchdog_Last;
               end if;
               if Accepted then
                  R.Misses := 0;
               else
                  Add_One (R.Misses);
                  Add_One (R.Missed_Sum);
               end if;
               R.Since_Reload := 0;
            end if;

         when Move | Turn =>
            if Result.Amount = 0 then
               Add_One (R.Stops_Sum);
            end if;
            if R.State not in Run | Movement then
               Accepted := False;
            elsif Result.Amount = 0 then
               Enter (R, Run);
            else
               Enter (R, Movement);
               if Result.Kind = Move then
                  Robot_Motion.Go (R.Motion, Result.Amount, R.Errors);
               else
                  Robot_Motion.Turn (R.Motion, Result.Amount, R.Errors);
               end if;
            end if;
      end case;

      Result.Reply := Framed (if Accepted then 'O' else 'E');
   end Obey;

   procedure Advance_To (R : in out Robot; Now : Time_Point) is
      Target : Robot_Motion.Micro;
      Start  : constant Time_Point := R.Now with Ghost;
   begin
      while R.Now < Now and then R.State /= Off loop
         pragma Loop_Invariant (R.Now >= Start);
         pragma Loop_Variant
           (Increases => R.Now, Increases => R.Next_Tick);

         --  To the next tick at most, so never by more than one

         Target := Robot_Motion.Micro'Min
           (Now, Robot_Motion.Micro'Min (R.Next_Tick, R.Now + Tick));
         if Target > R.Now then
            Robot_Motion.Advance (R.Motion, Target - R.Now);
            R.Now := Target;
         end if;
         if R.State = Movement and then not Robot_Motion.Is_Moving (R.Motion)
         then
            Enter (R, Run);
         end if;
         if R.Now >= R.Next_Tick then
            R.Next_Tick := R.Now + Tick;
            Do_Tick (R);
         end if;
      end loop;

      if R.Now < Now then
         R.Now := Now;
      end if;
   end Advance_To;

   function Checksum (Text : Octets) return Octet is
      Sum : Octet := 0;
   begin
      for Byte of Text loop
         Sum := Sum xor Byte;
      end loop;
      return (if Sum = Carriage_Return then Carriage_Return + 1 else Sum);
   end Checksum;

   procedure Place (R : in out Robot; At_Pose : Robot_Motion.Pose) is
   begin
      Robot_Motion.Place (R.Motion, At_Pose);
   end Place;

   procedure Receive
     (R        : in out Robot;
      Byte     : Octet;
      Complete : out Boolean;
      Result   : out Exchange) is
   begin
      Complete := False;
      Result   := (Before => R.State, After => R.State, others => <>);

      if Byte = NUL then
         return;
      elsif Byte /= Carriage_Return then
         if R.Input.Length < Max_Frame - 1 then
            R.Input.Length := R.Input.Length + 1;
            R.Input.Data (R.Input.Length) := Byte;
         else
            R.Input.Length := 0;
         end if;
         return;
      end if;

      Complete       := True;
      Result.Command := R.Input;
      R.Input.Length := 0;
      Add_One (R.Frames_Sum);
      Decode (Result.Command, Result.Kind, Result.Amount);
      if R.State not in Off | Low_Battery then
         Obey (R, Result);
      end if;
      Result.After := R.State;
   end Receive;

   procedure Set_Battery (R : in out Robot; Voltage : Centivolts) is
   begin
      R.Voltage := Voltage;
      Follow_Power (R);
   end Set_Battery;

   procedure Set_Charging (R : in out Robot; Plugged : Boolean) is
   begin
      R.Plugged := Plugged;
      Follow_Power (R);
   end Set_Charging;

   procedure Set_Wheels
     (R : in out Robot; Errors : Robot_Motion.Wheel_Errors) is
   begin
      R.Errors := Errors;
   end Set_Wheels;

   procedure Starve (R : in out Robot) is
   begin
      if R.Guarded then
         Add_One (R.Disabled_Sum);
         Enter (R, Watchdog_Disabled);
      end if;
   end Starve;

   procedure Switch_On (R : in out Robot; Boot : Tick_Count := Boot_Ticks) is
   begin
      Enter (R, Start_Up);
      R.Boot_Left    := Boot;
      R.Inactive     := 0;
      R.Since_Reload := 0;
      R.Misses       := 0;
      R.Input.Length := 0;
      R.Next_Tick    := R.Now + Tick;
      Follow_Power (R);
   end Switch_On;

end Robot_Core;
