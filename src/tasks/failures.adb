--  SPDX-License-Identifier: GPL-3.0-or-later

with Event;
with Failures.Handlers;
pragma Unreferenced (Failures.Handlers);
with Journal;
with Options;
with Process.Signals;
with Robot.Serial_Line;

package body Failures with SPARK_Mode is

   package Stop_Failed is new Event;

   function Line_Of (Item : Notice) return Texts.Text is
      --  For the log
      Line : Texts.Text;
   begin
      Texts.Append (Line, "internal failure: task ");
      Texts.Append (Line, Texts.Image (Item.Who));
      Texts.Append (Line, " ended");
      if Item.By_Exception then
         Texts.Append (Line, ", ");
         Texts.Append (Line, Texts.Image (Item.Name));
         Texts.Append (Line, " ");
         Texts.Append (Line, Texts.Image (Item.Message));
      end if;
      return Line;
   end Line_Of;

   procedure React (Item : Notice) is
   begin
      Journal.Put (Options.Error, Line_Of (Item));
      if Item.Of_Stop then
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
