--  SPDX-License-Identifier: GPL-3.0-or-later
--  The Ada side: what it passes on, and how it rounds.

package Vision_Tests is

   procedure Add_Tests;

end Vision_Tests;
