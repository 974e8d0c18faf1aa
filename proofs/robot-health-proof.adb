--  SPDX-License-Identifier: GPL-3.0-or-later

package body Robot.Health.Proof with SPARK_Mode is

   procedure Prove_Loss (Attempts : History) is
      H        : State := Initial;
      In_A_Row : Natural := 0;
      --  failed exchanges since the last success
   begin
      for A of Attempts loop
         pragma Loop_Invariant (In_A_Row < Max_Failures);
         pragma Loop_Invariant (H.Failures = In_A_Row);
         if A.Answered then
            In_A_Row := 0;
            H := Initial;
         else
            In_A_Row := In_A_Row + 1;
            H := After_Failure (H, A.Command);
         end if;
         pragma Assert (Lost (H) = (In_A_Row = 4));
         exit when Lost (H);
      end loop;
   end Prove_Loss;

end Robot.Health.Proof;
