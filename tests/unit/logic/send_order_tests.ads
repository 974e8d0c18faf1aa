--  SPDX-License-Identifier: GPL-3.0-or-later
--  What goes to the monitor next, and how long after the message before it.

package Send_Order_Tests is

   procedure Add_Tests;

end Send_Order_Tests;
