--  SPDX-License-Identifier: GPL-3.0-or-later
--  The ring of a trace: the newest events, and none that is mixed from two.

with AUnit.Test_Cases;

package Trace.Rings_Tests is

   type Test_Case is new AUnit.Test_Cases.Test_Case with null record;

   overriding procedure Register_Tests (T : in out Test_Case);

   overriding function Name (T : Test_Case) return AUnit.Message_String;

end Trace.Rings_Tests;
