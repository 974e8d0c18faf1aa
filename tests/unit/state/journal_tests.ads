--  SPDX-License-Identifier: GPL-3.0-or-later
--  The journal: first in first out, the capacity, what is not kept.

package Journal_Tests is

   procedure Add_Tests;

end Journal_Tests;
