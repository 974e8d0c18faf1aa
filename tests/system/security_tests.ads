--  SPDX-License-Identifier: GPL-3.0-or-later
--  Who is let in: addresses, tokens, and that no token gets into the log.

package Security_Tests is

   procedure Register;

end Security_Tests;
