--  SPDX-License-Identifier: GPL-3.0-or-later
--  F1 to F4 as far as they concern the server, and the command line.

with AUnit.Test_Suites;

package Server_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Server_Tests;
