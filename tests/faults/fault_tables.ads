--  SPDX-License-Identifier: GPL-3.0-or-later
--  The table of results: how often each fault was injected, alone and with
--  another, and how often something did not hold.

package Fault_Tables is

   procedure Count (First : Positive; Second : Natural; Violated : Boolean);
   --  One injection; Second 0 is First alone

   procedure Count_Impossible (First : Positive; Second : Natural);
   --  This machine does not allow it

   function Injections return Natural;
   function Violations return Natural;

   procedure Print (Path : String := "");
   --  Markdown, on standard output or into a file: a row a fault, then one
   --  for the pairs of two groups

end Fault_Tables;
