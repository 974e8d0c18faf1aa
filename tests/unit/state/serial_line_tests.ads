--  SPDX-License-Identifier: GPL-3.0-or-later
--  The serial line, on a pseudo-terminal: how long a read waits.

with AUnit.Test_Cases;

package Serial_Line_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Serial_Line_Tests;
