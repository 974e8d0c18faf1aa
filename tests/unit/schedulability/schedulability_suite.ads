--  SPDX-License-Identifier: GPL-3.0-or-later
--  All unit tests of the response-time analysis.

with AUnit.Test_Suites;

package Schedulability_Suite is

   function Suite return AUnit.Test_Suites.Access_Test_Suite;

end Schedulability_Suite;
