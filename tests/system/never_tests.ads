--  SPDX-License-Identifier: GPL-3.0-or-later
--  What must never happen, whatever comes in.

package Never_Tests is

   procedure Register;

end Never_Tests;
