--  SPDX-License-Identifier: GPL-3.0-or-later
--  Events: what is set is not lost, and wakes its task once.

package Event_Tests is

   procedure Add_Tests;

end Event_Tests;
