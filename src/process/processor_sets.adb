--  SPDX-License-Identifier: GPL-3.0-or-later

package body Processor_Sets with SPARK_Mode is

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

end Processor_Sets;
