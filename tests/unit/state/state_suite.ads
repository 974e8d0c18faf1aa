--  SPDX-License-Identifier: GPL-3.0-or-later
--  All unit tests of the protected state.

with AUnit.Test_Suites;

package State_Suite is

   function Suite return AUnit.Test_Suites.Access_Test_Suite;

end State_Suite;
