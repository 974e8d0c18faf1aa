--  SPDX-License-Identifier: GPL-3.0-or-later
--  The machine and the privileges of the measurement.

package Machines is

   procedure Report;

end Machines;
