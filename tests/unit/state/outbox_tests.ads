--  SPDX-License-Identifier: GPL-3.0-or-later
--  The outbox: images pass from hand to hand, and whoever waits is woken.

package Outbox_Tests is

   procedure Add_Tests;

end Outbox_Tests;
