--  SPDX-License-Identifier: GPL-3.0-or-later
--  What goes wrong with an answer on request.

package Answer_Faults_Tests is

   procedure Add_Tests;

end Answer_Faults_Tests;
