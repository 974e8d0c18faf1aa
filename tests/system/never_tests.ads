--  SPDX-License-Identifier: GPL-3.0-or-later
--  What must never happen, whatever comes in.

with AUnit.Test_Suites;

package Never_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Never_Tests;
