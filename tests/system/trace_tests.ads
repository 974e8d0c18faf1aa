--  SPDX-License-Identifier: GPL-3.0-or-later
--  The trace: --trace FILE, from the events in the supervisor to the file.

package Trace_Tests is

   procedure Register;

end Trace_Tests;
