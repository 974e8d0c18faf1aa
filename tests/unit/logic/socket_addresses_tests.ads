--  SPDX-License-Identifier: GPL-3.0-or-later
--  Addresses of peers as the kernel gives them.

package Socket_Addresses_Tests is

   procedure Add_Tests;

end Socket_Addresses_Tests;
