--  SPDX-License-Identifier: GPL-3.0-or-later
--  The record of a run, from which it can be continued: a file with a line
--  for what is tried, then one for each injection.

package Fault_Records is

   Wrong_Record : exception;
   --  The file is of another run, or cannot be used; the message says which

   procedure Open (Path : String; Seed : Natural);
   --  Reads what is there, or begins anew. Raises Wrong_Record where the seed,
   --  the supervisor, its library or the emulator are others than those of
   --  the file.

   function Result_Of (Key : String) return String;
   --  What is written there of the injection; "" where nothing is

   procedure Write (Key, Result : String);
   --  Nothing where no file is open. Raises Wrong_Record where it cannot be
   --  done

end Fault_Records;
