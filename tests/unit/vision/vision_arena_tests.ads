--  SPDX-License-Identifier: GPL-3.0-or-later
--  The search for the arena: under every disturbance, and where is none.

package Vision_Arena_Tests is

   procedure Add_Tests;

end Vision_Arena_Tests;
