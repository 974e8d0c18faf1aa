--  SPDX-License-Identifier: GPL-3.0-or-later
--  Vision.Sightings: what is seen, and whom it wakes.

package Vision_Sightings_Tests is

   procedure Add_Tests;

end Vision_Sightings_Tests;
