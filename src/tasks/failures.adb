--  SPDX-License-Identifier: GPL-3.0-or-later

with Event;
with Failures.Handlers;
pragma Unreferenced (Failures.Handlers);
with Journal;
with Options;
with Process.Signals;
with Robot.Serial_Line;
with Schedule;

package body Failures with SPARK_Mode is

   package Stop_Failed is new Event (Schedule.Main);

   procedure React (Line : Texts.Text; Of_Stop : Boolean) is
   begin
      Journal.Put (Options.Error, Line);
      if Of_Stop then
         Robot.Serial_Line.Stop_Blindly;
         Stop_Failed.Set;
      else
         Process.Signals.Report_Failure;
      end if;
   end React;

   procedure Wait_Stop_Failed is
   begin
      Stop_Failed.Wait;
   end Wait_Stop_Failed;

end Failures;
