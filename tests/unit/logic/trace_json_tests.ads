--  SPDX-License-Identifier: GPL-3.0-or-later
--  The text of a trace: each event, and that what begins there ends there.

with AUnit.Test_Cases;

package Trace_Json_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Trace_Json_Tests;
