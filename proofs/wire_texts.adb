--  SPDX-License-Identifier: GPL-3.0-or-later

package body Wire_Texts with SPARK_Mode is

   procedure Prove_Battery (Result : Commands.Outcome) is null;

   procedure Prove_Data_Labels is null;

   procedure Prove_Frame (C : Commands.Command) is null;

   procedure Prove_Labels is null;

   procedure Prove_Reply
     (Name : Robot_Command; Result : Commands.Outcome) is null;

   procedure Prove_Texts is null;

   procedure Prove_Vision_Reply (Done : Boolean) is null;

end Wire_Texts;
