--  SPDX-License-Identifier: GPL-3.0-or-later
--  Load on the machine.

package body Busy_Loops is

   procedure Start
     (Object   : in out Load;
      Count    : Positive := 2;
      Yielding : Boolean := False)
   is
      Loop_Forever : constant String := "while :; do :; done";
      Weight       : constant String := "/proc/self/autogroup";
      Options      : Child_Processes.Arguments;
   begin
      Options.Append ("-c");
      Options.Append
        (if not Yielding then Loop_Forever
         else "exec setsid nice -n 19 sh -c '[ ! -w " & Weight & " ] ||"
           & " echo 19 >" & Weight & "; " & Loop_Forever & "'");
      for Number in 1 .. Count loop
         Object.Loops (Number).Start ("/bin/sh", Options, "busy loop");
      end loop;
   end Start;

   procedure Stop (Object : in out Load) is
   begin
      for Item of Object.Loops loop
         Item.Stop;
      end loop;
   end Stop;

end Busy_Loops;
