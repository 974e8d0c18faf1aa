--  SPDX-License-Identifier: GPL-3.0-or-later
--  The firmware's state machine, row by row of docs/wire.md.

package Robot_Core_Tests is

   procedure Add_Tests;

end Robot_Core_Tests;
