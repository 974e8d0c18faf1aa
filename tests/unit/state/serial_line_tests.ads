--  SPDX-License-Identifier: GPL-3.0-or-later
--  The serial line, on a pseudo-terminal: how long a read waits.

package Serial_Line_Tests is

   procedure Add_Tests;

end Serial_Line_Tests;
