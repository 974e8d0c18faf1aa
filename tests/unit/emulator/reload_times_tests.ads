--  SPDX-License-Identifier: GPL-3.0-or-later

package Reload_Times_Tests is

   procedure Add_Tests;

end Reload_Times_Tests;
