--  SPDX-License-Identifier: GPL-3.0-or-later
--  The threads of the process: their names, the processors they run on, and
--  how they sleep.

with Ada.Real_Time;
with Options;
with Schedule;
with Trace;

package Process.Threads with SPARK_Mode is

   procedure Name_Task (Who : Schedule.Task_Name)
   with Global => (In_Out => System_State);
   --  The calling task is Who: ps -L and top -H show the first 15 letters of
   --  its name; the stack of a real-time task is in memory from here on.
   --  First of all that a task does, and once

   procedure Keep_On
     (Cpu : in out Options.Processor_Choice; Alone, Done : out Boolean)
   with Global => (In_Out => System_State);
   --  From here on the real-time tasks run on processor Cpu alone, and all
   --  other threads on the others; Alone: there are none. Cpu becomes the one
   --  that was meant. Done is false where this process may not run on Cpu

   procedure Sleep_Until
     (Who     : Schedule.Task_Name;
      At_Time : Ada.Real_Time.Time;
      Why     : Trace.Label_Text := Trace.No_Label)
   with Global => (Input  => Ada.Real_Time.Clock_Time,
                   In_Out => Trace.Recorder);
   --  The calling task, which is Who, sleeps until At_Time, when its next job
   --  begins; with Why, in the middle of a job

private

   type Set is array (Options.Processor) of Boolean
     with Pack, Size => 1_024;
   --  Of processors; as the C library's cpu_set_t

   type Division is array (Boolean) of Set;
   --  The processors of the real-time tasks (True) and of all other threads

   function Last_Of (Allowed : Set) return Options.Processor
   with
     Post =>
       (for all I in Last_Of'Result + 1 .. Set'Last => not Allowed (I))
       and then
         (if not Allowed (Last_Of'Result) then
             Last_Of'Result = 0
             and then (for all I in Set'Range => not Allowed (I)));
   --  The last one; 0 for none

   function Is_Alone (Allowed : Set) return Boolean is
     (for some I in Set'Range =>
        (for all J in Set'Range => Allowed (J) = (I = J)));
   --  There is one processor

   procedure Divide
     (Allowed : Set; Cpu : Options.Processor; Sets : out Division)
   with
     Pre  => Allowed (Cpu),
     Post => (for all I in Set'Range => Sets (True) (I) = (I = Cpu))
       and then
         (for all I in Set'Range =>
            Sets (False) (I) =
              (Allowed (I) and then (I /= Cpu or else Is_Alone (Allowed))));
   --  Cpu is for the real-time tasks alone, where there is another

end Process.Threads;
