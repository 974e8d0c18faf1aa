--  SPDX-License-Identifier: GPL-3.0-or-later
--  Random numbers, reproducible by a seed on all machines and compilers.

with Interfaces;

package Random_Numbers is

   type Generator is limited private;

   procedure Start (Source : in out Generator; Seed : Natural; Name : String);
   --  The sequence of Seed and Name: one for each fault and repetition, so
   --  that each can be repeated alone

   function Whole
     (Source : in out Generator; Low, High : Integer) return Integer
   with Pre => Low <= High;
   --  From Low to High, inclusive

   function Chance
     (Source : in out Generator; One_In : Positive) return Boolean;
   --  True once in One_In

   function Span
     (Source : in out Generator; Low, High : Duration) return Duration
   with Pre => Low <= High;

   function Octet (Source : in out Generator) return Character;

   function Text (Source : in out Generator; Size : Natural) return String;
   --  Printing characters

private

   type Generator is limited record
      State : Interfaces.Unsigned_64 := 0;
   end record;

end Random_Numbers;
