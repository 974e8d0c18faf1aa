--  SPDX-License-Identifier: GPL-3.0-or-later
--  Faults of a camera.

package Camera_Faults is

   procedure Register;
   --  Adds them to the list

end Camera_Faults;
