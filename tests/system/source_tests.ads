--  SPDX-License-Identifier: GPL-3.0-or-later
--  F14, F15: cameras of every rate, and V4L2 cameras of every kind.

with AUnit.Test_Suites;

package Source_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Source_Tests;
