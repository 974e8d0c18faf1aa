--  SPDX-License-Identifier: GPL-3.0-or-later
--  All unit tests of what judges the faults.

with AUnit.Test_Suites;

package Faults_Suite is

   function Suite return AUnit.Test_Suites.Access_Test_Suite;

end Faults_Suite;
