--  SPDX-License-Identifier: GPL-3.0-or-later
--  The arguments that the process was started with.

with Ada.Command_Line; use Ada.Command_Line;

package body Program_Arguments with
  SPARK_Mode    => Off,
  Refined_State => (Command_Line => null)
is

   ---------
   -- Get --
   ---------

   procedure Get
     (Index : Positive; Argument : out Texts.Text; Whole : out Boolean)
   is
      Value : constant String :=
        (if Index <= Argument_Count then Ada.Command_Line.Argument (Index)
         else "");
   begin
      Texts.Set (Argument, Value);
      Whole := Value'Length <= Texts.Max_Length;
   end Get;

   ---------------
   -- Get_Count --
   ---------------

   procedure Get_Count (Count : out Natural) is
   begin
      Count := Argument_Count;
   end Get_Count;

end Program_Arguments;
