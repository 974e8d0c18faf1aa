--  SPDX-License-Identifier: GPL-3.0-or-later
--  The supervisor as a process: signals, failures, privileges.

package Process_Tests is

   procedure Register;

end Process_Tests;
