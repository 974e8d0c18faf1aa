--  SPDX-License-Identifier: GPL-3.0-or-later
--  Faults caused by the machine and its administrator.

package Machine_Faults is

   procedure Register;
   --  Adds them to the list

end Machine_Faults;
