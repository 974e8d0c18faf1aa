--  SPDX-License-Identifier: GPL-3.0-or-later
--  The robot's line: lost at the fourth failure, and back into step.

package Line_Health_Tests is

   procedure Add_Tests;

end Line_Health_Tests;
