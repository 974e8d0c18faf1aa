--  SPDX-License-Identifier: GPL-3.0-or-later
--  Faults of the robot and its line.

package Robot_Faults is

   procedure Register;
   --  Adds them to the list

end Robot_Faults;
