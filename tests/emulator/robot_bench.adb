--  SPDX-License-Identifier: GPL-3.0-or-later
--  The one robot on the bench, shared by the tasks.

package body Robot_Bench is

   use Robot_Core;
   use all type Settings.Kind;

   use type Answer_Faults.Effect_Kind;

   Empty_Past : Robot_Pasts.Past;

   protected body Bench is

      procedure Begin_Life
        (Boot : Robot_Core.Tick_Count; Stay_On : Boolean) is
      begin
         Boot_Time := Boot;
         Stays_On := Stay_On;
         Past := Empty_Past;
         Switch_On;
      end Begin_Life;

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

      procedure Look (Robot : out Robot_Core.Robot; Time, Ago : Instant) is
      begin
         if Ago = 0 then
            Robot := The_Robot;
            Advance_To (Robot, Robot_Time (Time));
         else
            Robot := Robot_Pasts.Robot_At (Past, Robot_Time (Time - Ago));
         end if;
      end Look;

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

      procedure Set (Kind : Settings.Robot_Kind; Value : Integer) is
         Errors : Robot_Motion.Wheel_Errors := Wheels (The_Robot);
      begin
         Let_Time_Pass;
         case Kind is
            when Silent         => Faults.Silent := Value > 0;
            when Endless        =>
               Faults.Endless := Value > 0;
               Babbling := Babbling and then Value > 0;
            when Lose           => Faults.Lose := Value;
            when Lose_Every     =>
               Faults.Lose_Every  := Value;
               Faults.Lose_Passed := 0;
            when Drop           => Faults.Drop := Value;
            when Drop_Every     =>
               Faults.Every  := Value;
               Faults.Passed := 0;
            when Garbage        => Faults.Garbage := Value;
            when Truncate       => Faults.Truncate := Value;
            when Corrupt        => Faults.Corrupt := Value;
            when Flip           => Faults.Flip := Value;
            when Wrong          => Faults.Wrong := Value;
            when Pile           => Faults.Pile := Value;
            when Kept_Bytes     => Faults.Keep := Value;
            when Bit            => Faults.Bit := Value;
            when Answer_Delay   => Held_Back := Instant (Value) * 1_000_000;
            when Radio_Losses   => Radios.Losses := Value;
            when Radio_Bursts   => Radios.Bursts := Value;
            when Radio_Retries  => Radios.Retries := Value;
            when Battery        => Set_Battery (The_Robot, Value);
            when Charge         => Set_Charging (The_Robot, Value > 0);
            when Speed          => Errors.Speed := Value;
            when Turn_Speed     => Errors.Turn_Speed := Value;
            when Overshoot      => Errors.Overshoot := Value;
            when Pull           => Errors.Pull := Value;
         end case;
         Set_Wheels (The_Robot, Errors);
         if Kind in Battery | Charge then
            Robot_Pasts.Add (Past, The_Robot);
         end if;
      end Set;

      function Spoilt return Natural is (Spoilings);

      procedure Starve is
      begin
         Let_Time_Pass;
         Starve (The_Robot);
         Robot_Pasts.Add (Past, The_Robot);
      end Starve;

      procedure Switch_On is
      begin
         Let_Time_Pass;
         Switch_On (The_Robot, Boot_Time);
         Robot_Pasts.Add (Past, The_Robot);
         In_Frame := False;
      end Switch_On;

   end Bench;

end Robot_Bench;
