--  SPDX-License-Identifier: GPL-3.0-or-later
--  All groups of faults.

with Machine_Faults;
with Network_Faults;

package body Fault_List is

   procedure Register is
   begin
      Network_Faults.Register;
      Machine_Faults.Register;
   end Register;

end Fault_List;
