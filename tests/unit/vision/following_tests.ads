--  SPDX-License-Identifier: GPL-3.0-or-later
--  Robots that are followed: the same answers as a search everywhere gives.

package Following_Tests is

   procedure Add_Tests;

end Following_Tests;
