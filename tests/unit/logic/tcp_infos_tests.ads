--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the kernel tells of a connection, and of the queue of new ones.

package Tcp_Infos_Tests is

   procedure Add_Tests;

end Tcp_Infos_Tests;
