--  SPDX-License-Identifier: GPL-3.0-or-later
--  Whether every command is seen to be answered exactly once.

package Answer_Ledgers_Tests is

   procedure Add_Tests;

end Answer_Ledgers_Tests;
