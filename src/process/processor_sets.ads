--  SPDX-License-Identifier: GPL-3.0-or-later
--  The processors of the process: which of them the real-time tasks have for
--  themselves.

with Options;

package Processor_Sets with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Processor_Sets);

   type Set is array (Options.Processor) of Boolean
     with Pack, Size => 1_024;
   --  As the C library's cpu_set_t

   function Last_Of (Allowed : Set) return Options.Processor
   with
     Post =>
       (for all I in Last_Of'Result + 1 .. Set'Last => not Allowed (I))
       and then
         (if not Allowed (Last_Of'Result) then
             Last_Of'Result = 0
             and then (for all I in Set'Range => not Allowed (I)));
   --  The last one; 0 for none

   function Chosen
     (Allowed : Set; Cpu : Options.Processor_Choice)
      return Options.Processor_Choice
   is (if Cpu = Options.Last_Processor then Last_Of (Allowed) else Cpu);
   --  The one that is meant

   function Is_Alone (Allowed : Set) return Boolean is
     (for some I in Set'Range =>
        (for all J in Set'Range => Allowed (J) = (I = J)));
   --  There is one processor

   function May_Have
     (Allowed : Set; Cpu : Options.Processor_Choice) return Boolean
   is (Cpu = Options.No_Processor
       or else (Cpu in Options.Processor and then Allowed (Cpu)));

   type Division is array (Boolean) of Set;
   --  The processors of the real-time tasks (True) and of all other threads

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

end Processor_Sets;
