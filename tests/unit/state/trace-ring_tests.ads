--  SPDX-License-Identifier: GPL-3.0-or-later
--  The ring of a trace: the newest events, and none that is mixed from two.

package Trace.Ring_Tests is

   procedure Add_Tests;

end Trace.Ring_Tests;
