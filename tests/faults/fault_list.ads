--  SPDX-License-Identifier: GPL-3.0-or-later
--  All groups of faults.

package Fault_List is

   procedure Register;
   --  Adds them to Faults, in the order of the table

end Fault_List;
