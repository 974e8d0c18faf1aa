--  SPDX-License-Identifier: GPL-3.0-or-later
--  The monitor's lines: every label, numbers, line ends, answers, positions.

package Monitor_Protocol_Tests is

   procedure Add_Tests;

end Monitor_Protocol_Tests;
