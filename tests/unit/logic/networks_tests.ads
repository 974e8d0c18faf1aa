--  SPDX-License-Identifier: GPL-3.0-or-later
--  Networks of IPv4: their text, their addresses, and whom a list admits.

package Networks_Tests is

   procedure Add_Tests;

end Networks_Tests;
