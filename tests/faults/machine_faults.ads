--  SPDX-License-Identifier: GPL-3.0-or-later
--  What a machine and its administrator can do to the supervisor.

package Machine_Faults is

   procedure Register;
   --  Adds them to the list

end Machine_Faults;
