--  SPDX-License-Identifier: GPL-3.0-or-later
--  What waits for the monitor: order of the answers, the newest image, the
--  gap and the hold, by a clock of the test's own.

with AUnit.Test_Cases;

package Mailboxes_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding function Name (T : Test_Case) return AUnit.Message_String;

   overriding procedure Register_Tests (T : in out Test_Case);

end Mailboxes_Tests;
