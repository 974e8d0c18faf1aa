--  SPDX-License-Identifier: GPL-3.0-or-later
--  The table of results: how often each fault was injected, alone and in
--  pairs, and the number of violations.

package Fault_Tables is

   procedure Count (First : Positive; Second : Natural; Violated : Boolean);
   --  One injection; Second 0 is First alone

   procedure Count_Impossible (First : Positive; Second : Natural);
   --  This machine does not permit it

   function Injections return Natural;
   function Violations return Natural;

   procedure Print (Path : String := "");
   --  Markdown, on standard output or into a file: a row per fault, then one
   --  per pair of groups

end Fault_Tables;
