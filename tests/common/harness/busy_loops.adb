--  SPDX-License-Identifier: GPL-3.0-or-later
--  Load on the machine.

package body Busy_Loops is

   procedure Start (Object : in out Load; Yielding : Boolean := False) is
      Loop_Forever : constant String := "while :; do :; done";
      Weight       : constant String := "/proc/self/autogroup";
   begin
      for Item of Object.Loops loop
         Item.Launch
           ("sh|-c|"
            & (if not Yielding then Loop_Forever
               else "exec setsid nice -n 19 sh -c 'if [ -w " & Weight
                 & " ]; then echo 19 >" & Weight & "; fi; " & Loop_Forever
                 & "'"), '|');
      end loop;
   end Start;

   procedure Stop (Object : in out Load) is
   begin
      for Item of Object.Loops loop
         Item.Stop;
      end loop;
   end Stop;

end Busy_Loops;
