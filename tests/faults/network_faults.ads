--  SPDX-License-Identifier: GPL-3.0-or-later
--  Faults of the network and its users.

package Network_Faults is

   procedure Register;
   --  Adds them to the list

end Network_Faults;
