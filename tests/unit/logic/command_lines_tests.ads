--  SPDX-License-Identifier: GPL-3.0-or-later
--  The command line: every option, its limits, and what is refused.

package Command_Lines_Tests is

   procedure Add_Tests;

end Command_Lines_Tests;
