--  SPDX-License-Identifier: GPL-3.0-or-later
--  F4 to F6: the monitor, how it is served and how it is lost.

package Monitor_Tests is

   procedure Register;

end Monitor_Tests;
