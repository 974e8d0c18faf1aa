--  SPDX-License-Identifier: GPL-3.0-or-later
--  A run: which injections there are to be, and several processes that do
--  them side by side, for most of their time is waiting.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Worlds;                use Worlds;

package Fault_Runs is

   type Scope is record
      Seed  : Natural := 1;
      Times : Natural := 100;
      --  of each fault alone
      Pairs : Natural := 100;
      --  in which each fault is, with another at random
      Only  : Unbounded_String;
      --  a part of the name of a fault or a pair
      At_Repetition : Natural := 0;
      --  only this one; 0 is all
      Record_File   : Unbounded_String;
      --  where each result is written down; what is in it already is not
      --  done again. Empty: none
   end record;

   Most_Jobs : constant := 32;

   procedure Run
     (S        : Scope;
      Jobs     : Positive;
      Program  : String;
      Figures  : out Figure_Set)
     with Pre => Jobs <= Most_Jobs;
   --  Program is this one, which each of the jobs runs. Violations are
   --  printed as they come, and everything is counted in Fault_Tables.
   --  Figures are the worst of all. To be called from the environment task.
   --  Raises Fault_Records.Wrong_Record where Record_File is of another run.

   procedure Work (Seed : Natural);
   --  What each of the jobs does: takes injections from standard input, one
   --  a line, and answers on standard output

end Fault_Runs;
