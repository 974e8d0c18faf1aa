--  SPDX-License-Identifier: GPL-3.0-or-later
--  The slots and the file of a trace: which events are written, saved, skipped
--  and kept, and where.

with AUnit.Test_Cases;

package Trace_Layout_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Trace_Layout_Tests;
