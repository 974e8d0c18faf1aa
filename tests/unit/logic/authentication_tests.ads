--  SPDX-License-Identifier: GPL-3.0-or-later
--  The token: its file, the line that shows it, and what the log shows.

package Authentication_Tests is

   procedure Add_Tests;

end Authentication_Tests;
