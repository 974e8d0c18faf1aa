--  SPDX-License-Identifier: GPL-3.0-or-later
--  All unit tests of the emulator's core.

with AUnit.Test_Suites;

package Emulator_Suite is

   function Suite return AUnit.Test_Suites.Access_Test_Suite;

end Emulator_Suite;
