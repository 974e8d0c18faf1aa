--  SPDX-License-Identifier: GPL-3.0-or-later
--  All groups of faults.

with Camera_Faults;
with Machine_Faults;
with Network_Faults;
with Robot_Faults;

package body Fault_List is

   procedure Register is
   begin
      Network_Faults.Register;
      Robot_Faults.Register;
      Camera_Faults.Register;
      Machine_Faults.Register;
   end Register;

end Fault_List;
