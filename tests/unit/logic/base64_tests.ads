--  SPDX-License-Identifier: GPL-3.0-or-later
--  Base64: the vectors of RFC 4648, round trips, and what must be refused.

package Base64_Tests is

   procedure Add_Tests;

end Base64_Tests;
