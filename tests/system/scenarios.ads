--  SPDX-License-Identifier: GPL-3.0-or-later
--  The system tests: each is one procedure with a name, and is run by a
--  process of its own.

package Scenarios is

   procedure Add
     (Name    : String;
      Run     : not null access procedure;
      Timed   : Boolean := False;
      In_Time : Boolean := False);
   --  A test. Timed: its verdict depends on time, against a limit less than
   --  ten times what is usual. It runs when no other does, and what comes too
   --  late must do so in two of three runs; the verdict of all others is the
   --  same on any machine, however busy. In_Time: also adds the same, timed,
   --  as NAME_In_Time

   procedure Select_Timed;
   --  Timed tests are run, instead of all others

   procedure Add_Filter (Text : String);
   --  Tests whose name contains one of these are run, timed or not, but
   --  NAME_In_Time only if that word is in it

   procedure Select_One (Name : String);
   --  When this test is added, runs it, prints its report and ends the process
   --  as Run expects

   procedure Run (Jobs : Positive; Program : String; All_Passed : out Boolean);
   --  Runs the tests added: each in a process of Program, with the options of
   --  this one and --one NAME, Jobs at a time; then the timed ones, one by
   --  one. Ends with the number of tests passed and failed

end Scenarios;
