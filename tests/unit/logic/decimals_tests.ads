--  SPDX-License-Identifier: GPL-3.0-or-later
--  Decimal numbers: every count of digits, saturation, leading zeros.

package Decimals_Tests is

   procedure Add_Tests;

end Decimals_Tests;
