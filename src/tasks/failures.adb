--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Exceptions;           use Ada.Exceptions;
with Ada.Task_Identification;  use Ada.Task_Identification;
with Ada.Task_Termination;     use Ada.Task_Termination;
with Bytes;
with Interfaces.C;
with Robot.Protocol;
with Schedule;
with Support_Tasks;
with Texts;

package body Failures with SPARK_Mode => Off is
   --  Off: a termination handler is an access to a protected procedure, and
   --  what handles crashes is in src/main/crash_handlers.cpp. proofs/README.md
   --  says why React may do output inside this protected action

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
         Support_Tasks.React
           (Texts.Image (Line), Of_Stop => T = Support_Tasks.Th_Stop'Identity);
      end Ended;

   end Handler;

   procedure Catch_With (Stop : Bytes.Byte_Array; Length : Interfaces.C.int)
   with Import, Convention => C, External_Name => "destijl_catch_crashes";

   procedure Catch_Crashes is
      Frame : Robot.Protocol.Frame;
   begin
      Robot.Protocol.Encode (Robot.Protocol.Stop, Frame);
      Catch_With (Frame.Data, Interfaces.C.int (Frame.Length));
   end Catch_Crashes;

begin
   Set_Dependents_Fallback_Handler (Handler.Ended'Access);
end Failures;
