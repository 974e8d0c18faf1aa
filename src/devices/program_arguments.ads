--  SPDX-License-Identifier: GPL-3.0-or-later
--  The arguments that the process was started with.

with Texts;

package Program_Arguments with
  SPARK_Mode,
  Abstract_State => (Command_Line with Synchronous, External => Async_Writers),
  Initializes    => Command_Line
is

   procedure Get_Count (Count : out Natural)
   with Global => (In_Out => Command_Line);

   procedure Get
     (Index : Positive; Argument : out Texts.Text; Whole : out Boolean)
   with Global => (In_Out => Command_Line);
   --  The argument numbered Index from 1, empty where there is none. Where
   --  it does not fit, Whole is false and Argument holds what fits

end Program_Arguments;
