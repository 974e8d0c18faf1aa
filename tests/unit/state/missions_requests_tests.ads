--  SPDX-License-Identifier: GPL-3.0-or-later
--  Missions.Requests: one mission at a time.

package Missions_Requests_Tests is

   procedure Add_Tests;

end Missions_Requests_Tests;
