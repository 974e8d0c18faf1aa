--  SPDX-License-Identifier: GPL-3.0-or-later
--  What a fuzz target expects beyond the contracts of what it calls.

package Expectations is

   Broken : exception;

   procedure Expect (Condition : Boolean; Otherwise : String);
   --  Raises Broken where Condition is False; Otherwise says what is wrong

end Expectations;
