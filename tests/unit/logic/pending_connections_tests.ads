--  SPDX-License-Identifier: GPL-3.0-or-later
--  Pending connections: turns, room and shares, and that no source keeps
--  another one out, whatever comes.

package Pending_Connections_Tests is

   procedure Add_Tests;

end Pending_Connections_Tests;
