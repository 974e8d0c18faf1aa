--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Command_Line;

package body Program_Arguments with SPARK_Mode => Off is

   function Value (Index : Positive) return String is
     (if Index <= Count then Ada.Command_Line.Argument (Index) else "");

   function Argument (Index : Positive) return Texts.Text is
     (Texts.To_Text (Value (Index)));

   function Program return Texts.Text is
     (Texts.To_Text (Ada.Command_Line.Command_Name));

   function Count return Natural is (Ada.Command_Line.Argument_Count);

   function Is_Whole (Index : Positive) return Boolean is
     (Value (Index)'Length <= Texts.Max_Length);

end Program_Arguments;
