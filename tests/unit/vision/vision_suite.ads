--  SPDX-License-Identifier: GPL-3.0-or-later
--  All unit tests of the vision.

with AUnit.Test_Suites;

package Vision_Suite is

   function Suite return AUnit.Test_Suites.Access_Test_Suite;

end Vision_Suite;
