--  SPDX-License-Identifier: GPL-3.0-or-later
--  The system tests: each is one procedure or script with a name, and is run
--  by a process of its own.

with Rigs; use Rigs;

package Scenarios is

   procedure Read_Options;
   --  All tests but the timed ones are run; with --timed these, one by one.
   --  Arguments without dashes are parts of the names of tests to run, of both
   --  kinds, but NAME_In_Time only if that word is in one; --jobs N: how many
   --  at a time; those of Programs; --one NAME: see Run

   procedure Add
     (Name           : String;
      Run            : not null access procedure;
      Timed, In_Time : Boolean := False);
   --  A test. Timed: its verdict depends on time, against a limit less than
   --  ten times what is usual. It runs when no other does, and what comes too
   --  late must do so in two of three runs; the verdict of all others is the
   --  same on any machine, however busy. In_Time: also adds the same, timed,
   --  as NAME_In_Time

   procedure Script
     (Name               : String;
      Steps              : String   := "";
      Run                : access procedure (R : in out Rig) := null;
      Emulator_Options   : String   := "";
      Supervisor_Options : String   := "";
      Launcher           : String   := "";
      Camera             : Boolean  := False;
      Connected          : Boolean  := True;
      Terminal           : Boolean  := False;
      Times              : Positive := 1;
      Each               : String   := "";
      Timed, In_Time     : Boolean  := False);
   --  The same, of a rig that is assembled like this; it plays Steps (Times
   --  times, or for each word of Each), then Run

   procedure Run (All_Passed : out Boolean);
   --  Runs the tests added: each in a process of this program, with its
   --  options and --one NAME, several at a time; then the timed ones, one by
   --  one. Ends with the number of tests passed and failed

end Scenarios;
