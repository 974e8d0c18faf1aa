--  SPDX-License-Identifier: GPL-3.0-or-later
--  Random numbers, reproducible by a seed on all machines and compilers.

with Interfaces;

package Random_Numbers is

   type Generator is limited private;

   procedure Start (Source : in out Generator; Seed : Natural; Name : String);
   --  The sequence of Seed and Name: one for each mission, so
   --  that each can be repeated alone

   function Whole
     (Source : in out Generator; Low, High : Integer) return Integer
   with Pre => Low <= High;
   --  From Low to High, inclusive

private

   type Generator is limited record
      State : Interfaces.Unsigned_64 := 0;
   end record;

end Random_Numbers;
