--  SPDX-License-Identifier: GPL-3.0-or-later
--  The trace: --trace FILE, from the events in the supervisor to the file.

with AUnit.Test_Suites;

package Trace_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Trace_Tests;
