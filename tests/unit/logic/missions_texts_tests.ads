--  SPDX-License-Identifier: GPL-3.0-or-later
--  The lines on a mission: progress, every end, every refusal.

package Missions_Texts_Tests is

   procedure Add_Tests;

end Missions_Texts_Tests;
