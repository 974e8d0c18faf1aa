--  SPDX-License-Identifier: GPL-3.0-or-later
--  The ring of a trace: the newest events, and none that is mixed from two.

procedure Trace.Ring_Tests;
