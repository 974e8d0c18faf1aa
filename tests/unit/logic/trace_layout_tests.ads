--  SPDX-License-Identifier: GPL-3.0-or-later
--  The slots and the file of a trace: which events are written, saved, skipped
--  and kept, and where.

package Trace_Layout_Tests is

   procedure Add_Tests;

end Trace_Layout_Tests;
