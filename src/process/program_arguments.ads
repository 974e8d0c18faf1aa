--  SPDX-License-Identifier: GPL-3.0-or-later
--  The arguments of the process. They never change.

with Texts;

package Program_Arguments with SPARK_Mode is

   function Program return Texts.Text with Global => null;
   --  As it was called: with the path, unless it was found in PATH

   function Count return Natural with Global => null;

   function Is_Whole (Index : Positive) return Boolean with Global => null;
   --  Argument Index, counted from 1, fits into a text

   function Argument (Index : Positive) return Texts.Text
   with Global => null;
   --  As much of it as fits; empty if there is none

end Program_Arguments;
