--  SPDX-License-Identifier: GPL-3.0-or-later
--  The connection to the supervisor: received lines are processed at once,
--  commands are sent at once, and both end in one place.

with Words;

package Connections is

   procedure Open
     (Host       : String;
      Port       : Positive;
      First_Line : String;
      Failed     : out Boolean);
   --  Also sends First_Line, which has no answer, unless it is empty. Failures
   --  are reported to the user

   procedure Start (Timeout : Duration);
   --  Starts reading. A command without an answer after Timeout is unanswered.
   --  From now on the program ends by Finish, or with status 1 when the
   --  connection is lost.

   procedure Send (Line : String);
   --  Sends Line with its end

   procedure Await_Answers;
   --  Until every command is answered or overdue

   procedure Await (Class : Words.Message_Class; Come : out Boolean);
   --  The next such message, with the time limit of an answer. The end of a
   --  mission: the one since it was asked for, within ten minutes

   function Last_End return String;
   --  The text of the last mission's end

   function Last_Answer return String;
   --  The last command's answer; only its label if it is long; empty if none

   procedure Finish (Status : Natural) with No_Return;
   --  Closes the connection, prints the summary, ends the program: with
   --  Status, or 1 instead of 0 if a command is unanswered

end Connections;
