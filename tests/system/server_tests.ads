--  SPDX-License-Identifier: GPL-3.0-or-later
--  F1 to F4 as far as they concern the server, and the command line.

package Server_Tests is

   procedure Register;

end Server_Tests;
