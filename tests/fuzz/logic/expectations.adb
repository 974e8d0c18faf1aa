--  SPDX-License-Identifier: GPL-3.0-or-later
--  What a fuzz target expects beyond the contracts of what it calls.

package body Expectations is

   procedure Expect (Condition : Boolean; Otherwise : String) is
   begin
      if not Condition then
         raise Broken with Otherwise;
      end if;
   end Expect;

end Expectations;
