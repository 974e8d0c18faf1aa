--  SPDX-License-Identifier: GPL-3.0-or-later
--  Bounded texts: cut at their length, numbers in decimal.

package Texts_Tests is

   procedure Add_Tests;

end Texts_Tests;
