--  SPDX-License-Identifier: GPL-3.0-or-later
--  The one robot on the bench, shared by the tasks.

package body Robot_Bench is

   use Robot_Core;

   use type Answer_Faults.Effect_Kind;

   protected body Bench is

      procedure Babble (Byte : out Octet; Present : out Boolean) is
      begin
         Present := Babbling;
         if Babbling then
            Answer_Faults.Babble (Faults, Byte);
         else
            Byte := 0;
         end if;
      end Babble;

      function Chances return Radio_Links.Chances is (Radios);

      procedure Clear_Journal is
      begin
         Journals.Clear (Heard);
      end Clear_Journal;

      procedure Hear
        (Byte    : Octet;
         Started : Instant;
         Ended   : Instant;
         Wire    : out Answer_Faults.Wire_Bytes;
         Late    : out Instant)
      is
         Complete : Boolean;
         Note     : Journals.Note;
      begin
         Wire := (others => <>);
         Late := 0;
         if not In_Frame then
            In_Frame := True;
            First    := Started;
            Answer_Faults.Take_Command (Faults, Losing);
         end if;

         Advance_To (The_Robot, Robot_Time (Ended));
         if Losing then
            Miss (Byte, Started, Ended);
            In_Frame := In_Missed;
            return;
         end if;
         Receive (The_Robot, Byte, Complete, Note.Exchange);
         if not Complete then
            return;
         end if;
         In_Frame := False;
         Robot_Pasts.Add (Past, The_Robot);

         Answer_Faults.Apply
           (Faults, Note.Exchange.Kind, Note.Exchange.Reply, Wire,
            Note.Effect);
         if Wire.Length > 0 then
            Late := Held_Back;
         end if;
         Babbling := Babbling or else Note.Effect = Answer_Faults.Endless;
         if Note.Effect /= Answer_Faults.None or else Late > 0 then
            Spoilings := Spoilings + 1;
         end if;

         Note.First := First;
         Note.Last  := Ended;
         Note.Late  := Late;
         case Note.Exchange.Kind is
            when Reload =>
               if Reloaded /= 0 then
                  Note.Interval := Ended - Reloaded;
               end if;
               Reloaded := Ended;
            when Start | Start_With_Watchdog =>
               if Note.Exchange.Before = Idle then
                  Reloaded := Ended;
               end if;
            when others =>
               null;
         end case;
         Journals.Add (Heard, Note);
      end Hear;

      procedure Let_Time_Pass is
      begin
         Advance_To (The_Robot, Robot_Time (Now));
         if Stays_On and then State (The_Robot) = Off then
            Switch_On (The_Robot, Boot_Time);
            Robot_Pasts.Add (Past, The_Robot);
         end if;
      end Let_Time_Pass;

      procedure Look (Robot : out Robot_Core.Robot) is
      begin
         Robot := The_Robot;
      end Look;

      procedure Look_Back
        (Robot : out Robot_Core.Robot; Time : Robot_Core.Time_Point) is
      begin
         Robot := Robot_Pasts.Robot_At (Past, Time);
      end Look_Back;

      procedure Mend is
      begin
         Faults    := (Seed => Faults.Seed, Turn => Faults.Turn, others => <>);
         Held_Back := 0;
         Babbling  := False;
         Radios    := (Retries => Radios.Retries, others => <>);
      end Mend;

      procedure Miss (Byte : Octet; Started, Ended : Instant) is
         Complete : Boolean;
         Note     : Journals.Note;
      begin
         if not In_Missed then
            Missed := Started;
         end if;
         Receive (Nobody, Byte, Complete, Note.Exchange);
         In_Missed := not Complete;
         if Complete then
            Note.Exchange.Before := State (The_Robot);
            Note.Exchange.After  := State (The_Robot);
            Note.First  := Missed;
            Note.Last   := Ended;
            Note.Effect := Answer_Faults.Lost;
            Spoilings   := Spoilings + 1;
            Journals.Add (Heard, Note);
         end if;
      end Miss;

      procedure Miss_Answers is
      begin
         Spoilings := Spoilings + 1;
      end Miss_Answers;

      procedure Next_Note
        (After : Journals.Note_Number;
         Note  : out Journals.Note;
         Found : out Journals.Note_Number) is
      begin
         Journals.Find (Heard, After, Note, Found);
      end Next_Note;

      procedure Place (Pose : Robot_Motion.Pose) is
      begin
         Let_Time_Pass;
         Place (The_Robot, Pose);
         Robot_Pasts.Add (Past, The_Robot);
      end Place;

      procedure Set_Battery (Voltage : Centivolts) is
      begin
         Let_Time_Pass;
         Set_Battery (The_Robot, Voltage);
         Robot_Pasts.Add (Past, The_Robot);
      end Set_Battery;

      procedure Set_Charging (Plugged : Boolean) is
      begin
         Let_Time_Pass;
         Set_Charging (The_Robot, Plugged);
         Robot_Pasts.Add (Past, The_Robot);
      end Set_Charging;

      procedure Set_Delay (Value : Instant) is
      begin
         Held_Back := Value;
      end Set_Delay;

      procedure Set (Kind : Fault_Kind; Value : Natural) is
      begin
         case Kind is
            when Lose          => Faults.Lose := Value;
            when Lose_Every    =>
               Faults.Lose_Every  := Value;
               Faults.Lose_Passed := 0;
            when Drop          => Faults.Drop := Value;
            when Drop_Every    =>
               Faults.Every  := Value;
               Faults.Passed := 0;
            when Corrupt       => Faults.Corrupt := Value;
            when Garbage       => Faults.Garbage := Value;
            when Truncate      => Faults.Truncate := Value;
            when Radio_Losses  => Radios.Losses := Value;
            when Radio_Bursts  => Radios.Bursts := Value;
            when Radio_Retries => Radios.Retries := Value;
            when Flip          => Faults.Flip := Value;
            when Wrong         => Faults.Wrong := Value;
            when Pile          => Faults.Pile := Value;
            when Silent        => Faults.Silent := Value > 0;
            when Endless       =>
               Faults.Endless := Value > 0;
               Babbling := Babbling and then Value > 0;
            when Kept_Bytes    => Faults.Keep := Value;
            when Bit           => Faults.Bit := Value;
         end case;
      end Set;

      procedure Stay_On is
      begin
         Stays_On := True;
      end Stay_On;

      procedure Set_Wheels (Errors : Robot_Motion.Wheel_Errors) is
      begin
         Set_Wheels (The_Robot, Errors);
      end Set_Wheels;

      function Spoilt return Natural is (Spoilings);

      procedure Starve is
      begin
         Let_Time_Pass;
         Starve (The_Robot);
         Robot_Pasts.Add (Past, The_Robot);
      end Starve;

      procedure Switch_On (Boot : Tick_Count) is
      begin
         Boot_Time := Boot;
         Switch_On;
      end Switch_On;

      procedure Switch_On is
      begin
         Let_Time_Pass;
         Switch_On (The_Robot, Boot_Time);
         Robot_Pasts.Add (Past, The_Robot);
         In_Frame := False;
      end Switch_On;

      function Wheels return Robot_Motion.Wheel_Errors is
        (Wheels (The_Robot));

   end Bench;

   procedure Look
     (Robot   : out Robot_Core.Robot;
      At_Time : Instant;
      Ago     : Instant := 0) is
   begin
      if Ago = 0 then
         Bench.Look (Robot);
         Advance_To (Robot, Robot_Time (At_Time));
      else
         Bench.Look_Back (Robot, Robot_Time (At_Time - Ago));
      end if;
   end Look;

end Robot_Bench;
