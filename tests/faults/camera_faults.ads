--  SPDX-License-Identifier: GPL-3.0-or-later
--  What a camera can do to the supervisor.

package Camera_Faults is

   procedure Register;
   --  Adds them to the list

end Camera_Faults;
