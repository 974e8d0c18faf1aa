--  SPDX-License-Identifier: GPL-3.0-or-later
--  The tasks' ports: first in first out, the capacity, the end of a session.

package Order_Ports_Tests is

   procedure Add_Tests;

end Order_Ports_Tests;
