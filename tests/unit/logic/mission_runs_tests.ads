--  SPDX-License-Identifier: GPL-3.0-or-later
--  The runs of missions, their angles and their guards.

package Mission_Runs_Tests is

   procedure Add_Tests;

end Mission_Runs_Tests;
