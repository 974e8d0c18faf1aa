--  SPDX-License-Identifier: GPL-3.0-or-later
--  The arguments that the process was started with. They never change.

with Texts;

package Program_Arguments with SPARK_Mode is

   function Count return Natural with Global => null;

   function Is_Whole (Index : Positive) return Boolean with Global => null;
   --  The argument numbered Index from 1 is not longer than a text may be

   function Argument (Index : Positive) return Texts.Text
   with Global => null;
   --  As much of it as fits; empty where there is none

end Program_Arguments;
