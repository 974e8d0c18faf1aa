--  SPDX-License-Identifier: GPL-3.0-or-later
--  What waits for the monitor: order of the answers, the newest image, the
--  gap and the hold, by a clock of the test's own.

package Mailboxes_Tests is

   procedure Add_Tests;

end Mailboxes_Tests;
