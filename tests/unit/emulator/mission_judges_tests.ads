--  SPDX-License-Identifier: GPL-3.0-or-later
--  What judges missions: plans, the truth from a journal, verdicts.

package Mission_Judges_Tests is

   procedure Add_Tests;

end Mission_Judges_Tests;
