--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the figures were taken on, and with what rights.

package Machines is

   procedure Report;

end Machines;
