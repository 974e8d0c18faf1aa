--  SPDX-License-Identifier: GPL-3.0-or-later
--  Who is let in: addresses, tokens, and that no token gets into the log.

with AUnit.Test_Suites;

package Security_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Security_Tests;
