--  SPDX-License-Identifier: GPL-3.0-or-later
--  The record of a run, for its continuation: a file with a line for what is
--  tested, then one for each injection.

package Fault_Records is

   Wrong_Record : exception;
   --  The file is of another run, or cannot be used; the message says which

   procedure Open (Path : String; Seed : Natural);
   --  Reads an existing file, or starts a new one. Raises Wrong_Record if
   --  seed, supervisor, library or emulator differ from those of the file.

   function Result_Of (Key : String) return String;
   --  The recorded result of the injection; "" if none

   procedure Write (Key, Result : String);
   --  No effect if no file is open. Raises Wrong_Record on failure

end Fault_Records;
