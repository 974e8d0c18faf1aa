--  SPDX-License-Identifier: GPL-3.0-or-later
--  Addresses of peers as the kernel gives them.

with AUnit;
with AUnit.Test_Cases;

package Socket_Addresses_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding function Name (T : Test_Case) return AUnit.Message_String;

   overriding procedure Register_Tests (T : in out Test_Case);

end Socket_Addresses_Tests;
