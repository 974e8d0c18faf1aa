--  SPDX-License-Identifier: GPL-3.0-or-later
--  A run: its list of injections, and several processes that perform them in
--  parallel, as they mostly wait.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Worlds;                use Worlds;

package Fault_Runs is

   type Scope is record
      Seed  : Natural := 1;
      Times : Natural := 100;
      --  of each fault alone
      Pairs : Natural := 100;
      --  per fault, combined with a random one
      Only  : Unbounded_String;
      --  part of the name of a fault or a pair
      At_Repetition : Natural := 0;
      --  only this repetition; 0: all
      Record_File   : Unbounded_String;
      --  file for the results; injections already in it are not repeated.
      --  Empty: none
   end record;

   Most_Jobs : constant := 32;

   procedure Run
     (S        : Scope;
      Jobs     : Positive;
      Program  : String;
      Figures  : out Figure_Set)
     with Pre => Jobs <= Most_Jobs;
   --  Program is this one, run by each job. Violations are printed at once,
   --  and all results are counted in Fault_Tables. Figures are the worst of
   --  all. To be called by the environment task. Raises
   --  Fault_Records.Wrong_Record if Record_File belongs to another run.

   procedure Work (Seed : Natural);
   --  A job: takes injections from standard input, one per line, and answers
   --  on standard output

end Fault_Runs;
