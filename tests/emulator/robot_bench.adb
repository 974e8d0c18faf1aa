--  SPDX-License-Identifier: GPL-3.0-or-later
--  The one robot on the bench, shared by the tasks.

package body Robot_Bench is

   use Robot_Core;

   protected body Bench is

      -------------------
      -- Clear_Journal --
      -------------------

      procedure Clear_Journal is
      begin
         Journals.Clear (Heard);
      end Clear_Journal;

      ----------
      -- Hear --
      ----------

      procedure Hear
        (Byte    : Octet;
         Started : Libc.Nanoseconds;
         Ended   : Libc.Nanoseconds;
         Wire    : out Answer_Faults.Wire_Bytes;
         Late    : out Libc.Nanoseconds)
      is
         Complete : Boolean;
         Note     : Journals.Note;
      begin
         Wire := (others => <>);
         Late := 0;
         if not In_Frame then
            In_Frame := True;
            First    := Started;
         end if;

         Advance_To (The_Robot, Robot_Time (Ended));
         Receive (The_Robot, Byte, Complete, Note.Exchange);
         if not Complete then
            return;
         end if;
         In_Frame := False;

         Answer_Faults.Apply
           (Faults, Note.Exchange.Reply, Wire, Note.Effect);
         if Wire.Length > 0 then
            Late := Held_Back;
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

      -------------------
      -- Let_Time_Pass --
      -------------------

      procedure Let_Time_Pass is
      begin
         Advance_To (The_Robot, Robot_Time (Libc.Now));
      end Let_Time_Pass;

      ----------
      -- Look --
      ----------

      procedure Look (Robot : out Robot_Core.Robot) is
      begin
         Robot := The_Robot;
      end Look;

      procedure Look (Faults : out Answer_Faults.Plan) is
      begin
         Faults := Bench.Faults;
      end Look;

      ---------------
      -- Next_Note --
      ---------------

      procedure Next_Note
        (After : Journals.Note_Number;
         Note  : out Journals.Note;
         Found : out Journals.Note_Number) is
      begin
         Journals.Find (Heard, After, Note, Found);
      end Next_Note;

      -----------
      -- Place --
      -----------

      procedure Place (Pose : Robot_Motion.Pose) is
      begin
         Let_Time_Pass;
         Place (The_Robot, Pose);
      end Place;

      -----------------
      -- Set_Battery --
      -----------------

      procedure Set_Battery (Level : Battery_Level) is
      begin
         Let_Time_Pass;
         Set_Battery (The_Robot, Level);
      end Set_Battery;

      ------------------
      -- Set_Charging --
      ------------------

      procedure Set_Charging (Plugged : Boolean) is
      begin
         Let_Time_Pass;
         Set_Charging (The_Robot, Plugged);
      end Set_Charging;

      ---------------
      -- Set_Delay --
      ---------------

      procedure Set_Delay (Value : Libc.Nanoseconds) is
      begin
         Held_Back := Value;
      end Set_Delay;

      ---------------
      -- Set_Fault --
      ---------------

      procedure Set_Fault
        (Kind : Fault_Kind; Value : Answer_Faults.Remaining) is
      begin
         case Kind is
            when Drop =>
               Faults.Drop := Value;
            when Corrupt =>
               Faults.Corrupt := Value;
            when Garbage =>
               Faults.Garbage := Value;
            when Truncate =>
               Faults.Truncate := Value;
         end case;
      end Set_Fault;

      ----------------
      -- Set_Silent --
      ----------------

      procedure Set_Silent (Value : Boolean) is
      begin
         Faults.Silent := Value;
      end Set_Silent;

      ---------------
      -- Switch_On --
      ---------------

      procedure Switch_On (Boot : Tick_Count) is
      begin
         Boot_Time := Boot;
         Switch_On;
      end Switch_On;

      procedure Switch_On is
      begin
         Let_Time_Pass;
         Switch_On (The_Robot, Boot_Time);
         In_Frame := False;
      end Switch_On;

   end Bench;

   ----------
   -- Look --
   ----------

   procedure Look (Robot : out Robot_Core.Robot; At_Time : Libc.Nanoseconds)
   is
   begin
      Bench.Look (Robot);
      Advance_To (Robot, Robot_Time (At_Time));
   end Look;

end Robot_Bench;
