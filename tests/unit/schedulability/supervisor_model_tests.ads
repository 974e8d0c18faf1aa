--  SPDX-License-Identifier: GPL-3.0-or-later
--  The supervisor as the analysis sees it: complete, and sensitive.

package Supervisor_Model_Tests is

   procedure Add_Tests;

end Supervisor_Model_Tests;
