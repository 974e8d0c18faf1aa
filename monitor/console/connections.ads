--  SPDX-License-Identifier: GPL-3.0-or-later
--  The connection to the supervisor: what comes is taken into account as
--  it comes, what is said goes out at once, and both end in one place.

with Words;

package Connections is

   procedure Open
     (Host       : String;
      Port       : Positive;
      First_Line : String;
      Failed     : out Boolean);
   --  And says First_Line, which has no answer, unless it is empty. The user
   --  is told why it failed

   procedure Start (Timeout : Duration);
   --  Begin to read. A command without an answer after Timeout is
   --  unanswered. From now on the program ends by Finish, or by itself
   --  with status 1 when the connection is lost.

   procedure Send (Line : String);
   --  Line, its end added

   procedure Await_Answers;
   --  Until every command has its answer, or is unanswered

   procedure Await (Class : Words.Message_Class; Come : out Boolean);
   --  The next such message, as long as for an answer

   function Last_Answer return String;
   --  The last command's, only its label if it is long; empty if none

   procedure Finish (Status : Natural) with No_Return;
   --  Close the connection, put the summary, end the program: with Status,
   --  or 1 in place of 0 if a command is unanswered

end Connections;
