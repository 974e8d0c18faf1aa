--  SPDX-License-Identifier: GPL-3.0-or-later

package body Wire_Texts with SPARK_Mode is

   procedure Prove_Answer
     (Kind : Robot_Order; Result : Robot.Session.Outcome) is null;

   procedure Prove_Command (M : Message) is null;

   procedure Prove_Label (Kind : Known_Kind) is null;

   procedure Prove_Other_Answers is null;

   procedure Prove_Vision_Answer (Done : Boolean) is null;

end Wire_Texts;
