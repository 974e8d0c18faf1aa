--  SPDX-License-Identifier: GPL-3.0-or-later
--  The points of a mission: coordinates, their number, and what is no path.

package Missions_Paths_Tests is

   procedure Add_Tests;

end Missions_Paths_Tests;
