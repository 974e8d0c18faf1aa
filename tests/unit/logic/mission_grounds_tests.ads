--  SPDX-License-Identifier: GPL-3.0-or-later
--  The ground of a mission: what it needs, what ends it, its times.

package Mission_Grounds_Tests is

   procedure Add_Tests;

end Mission_Grounds_Tests;
