--  SPDX-License-Identifier: GPL-3.0-or-later

package body Robot.Line_Status.Proof with SPARK_Mode is

   procedure Prove_Windows (First : First_Tick) is null;

end Robot.Line_Status.Proof;
