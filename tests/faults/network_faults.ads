--  SPDX-License-Identifier: GPL-3.0-or-later
--  What a network and those who use it can do to the supervisor.

package Network_Faults is

   procedure Register;
   --  Adds them to the list

end Network_Faults;
