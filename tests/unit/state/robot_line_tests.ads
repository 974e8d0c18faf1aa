--  SPDX-License-Identifier: GPL-3.0-or-later
--  The line's requests: urgency, void movements, places kept.

package Robot_Line_Tests is

   procedure Add_Tests;

end Robot_Line_Tests;
