--  SPDX-License-Identifier: GPL-3.0-or-later
--  F4 to F6: the monitor, how it is served and how it is lost.

with AUnit.Test_Suites;

package Monitor_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Monitor_Tests;
