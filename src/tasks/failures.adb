--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Exceptions;           use Ada.Exceptions;
with Ada.Task_Identification;  use Ada.Task_Identification;
with Ada.Task_Termination;     use Ada.Task_Termination;
with Event;
with Journal;
with Options;
with Process.Signals;
with Robot.Serial_Line;
with Schedule;
with Support_Tasks;
with Trace;

package body Failures with
  SPARK_Mode    => Off,
  Refined_State => (Stop_Task => Has_Failed)
is
   --  Off: a termination handler is an access to a protected procedure

   protected Fallback with Priority => Schedule.Journal_Ceiling is
      procedure Ended
        (Cause : Cause_Of_Termination; T : Task_Id; X : Exception_Occurrence);
   end Fallback;

   package Stop_Failed is new Event;
   Has_Failed : Boolean := False with Atomic;

   protected body Fallback is

      procedure Ended
        (Cause : Cause_Of_Termination; T : Task_Id; X : Exception_Occurrence)
      is
      begin
         Journal.Put
           (Options.Error,
            "internal failure: task " & Image (T) & " ended"
            & (if Cause = Unhandled_Exception
               then ", " & Exception_Name (X) & " " & Exception_Message (X)
               else ""));
         if T = Support_Tasks.Th_Stop'Identity then
            Robot.Serial_Line.Stop_Blindly;
            Has_Failed := True;
            Stop_Failed.Set;
            Trace.Wake;
         else
            Process.Signals.Report_Failure;
         end if;
      end Ended;

   end Fallback;

   procedure Get_Stop_Failed (Failed : out Boolean) is
   begin
      Failed := Has_Failed;
   end Get_Stop_Failed;

   procedure Wait_Stop_Failed is
   begin
      Stop_Failed.Wait;
   end Wait_Stop_Failed;

begin
   Set_Dependents_Fallback_Handler (Fallback.Ended'Access);
end Failures;
