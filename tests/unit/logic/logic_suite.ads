--  SPDX-License-Identifier: GPL-3.0-or-later
--  All unit tests of the pure packages.

with AUnit.Test_Suites;

package Logic_Suite is

   function Suite return AUnit.Test_Suites.Access_Test_Suite;

end Logic_Suite;
