--  SPDX-License-Identifier: GPL-3.0-or-later
--  For any sequence of exchanges: the line is lost exactly when the last four
--  have failed, and any success restores the initial state.

package Robot.Health.Proof with SPARK_Mode, Ghost is

   type Attempt is record
      Command  : Command_Kind;
      Answered : Boolean;
   end record;

   type History is array (Positive range <>) of Attempt;

   procedure Prove_Loss (Attempts : History);
   --  Asserted in the body

end Robot.Health.Proof;
