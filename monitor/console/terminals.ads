--  SPDX-License-Identifier: GPL-3.0-or-later
--  Standard output and standard error, shared by the tasks: lines that
--  stay and, on a terminal, one line below them that is kept up to date.

package Terminals is

   function Output_Is_Terminal return Boolean;
   --  Standard output is one, and it understands cursor movements

   function Input_Is_Terminal return Boolean;

   procedure Start (Interactive : Boolean);
   --  Called once, first. Interactive: below the status line there is one
   --  to type in.

   procedure Put_Line (Line : String);
   --  Bytes that would move the cursor are shown as '?'.

   function Is_Heard return Boolean;
   --  Standard output has taken all that was put there

   procedure Put_Error (Line : String);
   --  On standard error, with the program's name before it

   procedure Set_Status (Line : String);
   --  Replaces the status line. Without effect if there is no terminal.

   procedure Line_Typed;
   --  The user has ended a line: the cursor is on the next

   procedure Finish;
   --  Takes the status line away. Nothing but lines comes after it.

end Terminals;
