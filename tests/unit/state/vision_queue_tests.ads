--  SPDX-License-Identifier: GPL-3.0-or-later
--  The orders to the vision: one at a time, in the order of the commands.

package Vision_Queue_Tests is

   procedure Add_Tests;

end Vision_Queue_Tests;
