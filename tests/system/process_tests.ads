--  SPDX-License-Identifier: GPL-3.0-or-later
--  The supervisor as a process: signals, failures, privileges.

with AUnit.Test_Suites;

package Process_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Process_Tests;
