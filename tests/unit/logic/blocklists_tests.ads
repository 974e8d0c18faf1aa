--  SPDX-License-Identifier: GPL-3.0-or-later
--  Blocklists: who floods, and who only connects now and then.

package Blocklists_Tests is

   procedure Add_Tests;

end Blocklists_Tests;
