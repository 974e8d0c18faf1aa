--  SPDX-License-Identifier: GPL-3.0-or-later

with Process.Threads.Calls;

package body Process.Threads with SPARK_Mode is

   procedure Name_Task (Who : Schedule.Task_Name) renames Calls.Enter;

   procedure Keep_On
     (Cpu : in out Options.Processor_Choice; Alone, Done : out Boolean)
   is
      Allowed : Set;
      Sets    : Division;
   begin
      Calls.Get_Allowed (Allowed);
      Alone := Is_Alone (Allowed);
      if Cpu = Options.Last_Processor then
         Cpu := Last_Of (Allowed);
      end if;
      Done := Cpu = Options.No_Processor
        or else (Cpu in Options.Processor and then Allowed (Cpu));
      if Done and then Cpu in Options.Processor then
         Divide (Allowed, Cpu, Sets);
         Calls.Keep (Sets);
      end if;
   end Keep_On;

   procedure Sleep_Until
     (Who     : Schedule.Task_Name;
      At_Time : Ada.Real_Time.Time;
      Why     : Trace.Label_Text := Trace.No_Label)
   is
      In_Job : constant Boolean := Why /= Trace.No_Label;
   begin
      Trace.Put ((if In_Job then Trace.Wait else Trace.Done), Who,
                 Label => Why);
      delay until At_Time;
      Trace.Put_Due (Who, At_Time);
      Trace.Put ((if In_Job then Trace.Resume else Trace.Start), Who);
   end Sleep_Until;

   function Last_Of (Allowed : Set) return Options.Processor is
   begin
      for I in reverse Set'Range loop
         if Allowed (I) then
            return I;
         end if;
         pragma Loop_Invariant
           (for all J in I .. Set'Last => not Allowed (J));
      end loop;
      return 0;
   end Last_Of;

   procedure Divide
     (Allowed : Set; Cpu : Options.Processor; Sets : out Division)
   is
      Alone : constant Boolean := Is_Alone (Allowed);
   begin
      Sets := (others => (others => False));
      Sets (True) (Cpu) := True;
      Sets (False) := Allowed;
      if not Alone then
         Sets (False) (Cpu) := False;
      end if;
   end Divide;

end Process.Threads;
