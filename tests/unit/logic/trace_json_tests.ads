--  SPDX-License-Identifier: GPL-3.0-or-later
--  The text of a trace: each event, and that what begins there ends there.

package Trace_Json_Tests is

   procedure Add_Tests;

end Trace_Json_Tests;
