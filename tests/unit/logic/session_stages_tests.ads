--  SPDX-License-Identifier: GPL-3.0-or-later
--  The stages of a session: their order, and that none begins at the end.

package Session_Stages_Tests is

   procedure Add_Tests;

end Session_Stages_Tests;
