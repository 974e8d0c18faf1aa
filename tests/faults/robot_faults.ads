--  SPDX-License-Identifier: GPL-3.0-or-later
--  What a robot and its line can do to the supervisor.

package Robot_Faults is

   procedure Register;
   --  Adds them to the list

end Robot_Faults;
