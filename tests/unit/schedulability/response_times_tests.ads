--  SPDX-License-Identifier: GPL-3.0-or-later
--  The analysis on published examples whose answers are known.

package Response_Times_Tests is

   procedure Add_Tests;

end Response_Times_Tests;
