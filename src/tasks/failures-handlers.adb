--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Exceptions;           use Ada.Exceptions;
with Ada.Task_Identification;  use Ada.Task_Identification;
with Ada.Task_Termination;     use Ada.Task_Termination;
with Schedule;
with Support_Tasks;

package body Failures.Handlers with SPARK_Mode => Off is
   --  Off: a termination handler is an access to a protected procedure.
   --
   --  React does output inside this protected action, for which GNATprove
   --  would report calls that may block. It is not left to another task: where
   --  th_stop has failed only the main procedure waits for that, with the
   --  lowest priority. React waits for nothing: it locks the log's buffer, of
   --  the same ceiling, reads the clock, adds to event counters (which wait
   --  at 2 ** 64 only), and writes to the robot's line, which is non-blocking,
   --  or sends a signal to the own process. That no exception is raised is
   --  proved of what is in SPARK; the texts are truncated, not rejected. That
   --  the system calls return at once is not claimed by proof

   protected Handler with Priority => Schedule.Journal_Ceiling is
      procedure Ended
        (Cause : Cause_Of_Termination; T : Task_Id; X : Exception_Occurrence);
   end Handler;

   protected body Handler is

      procedure Ended
        (Cause : Cause_Of_Termination; T : Task_Id; X : Exception_Occurrence)
      is
         Line : Texts.Text;
      begin
         Texts.Set (Line, "internal failure: task ");
         Texts.Append (Line, Image (T));
         Texts.Append (Line, " ended");
         if Cause = Unhandled_Exception then
            Texts.Append (Line, ", ");
            Texts.Append (Line, Exception_Name (X));
            Texts.Append (Line, " ");
            Texts.Append (Line, Exception_Message (X));
         end if;
         React (Line, Of_Stop => T = Support_Tasks.Th_Stop'Identity);
      end Ended;

   end Handler;

begin
   Set_Dependents_Fallback_Handler (Handler.Ended'Access);
end Failures.Handlers;
