--  SPDX-License-Identifier: GPL-3.0-or-later
--  Reaction to the end of a task, as none may end: the robot is stopped, then
--  the process.

with Texts;

package Failures with SPARK_Mode is

   procedure Wait_Stop_Failed;
   --  Waits until the task that ends the process has failed itself: the caller
   --  must end the process. For one task only

private

   type Notice is record
      Of_Stop      : Boolean := False;
      --  it was the task that ends the process
      Who          : Texts.Text;
      By_Exception : Boolean := False;
      Name         : Texts.Text;
      Message      : Texts.Text;
      --  of the exception, if any
   end record;
   --  What the run time tells of a task that has ended

   procedure React (Item : Notice);
   --  For the handler of Failures.Handlers: puts a line into the log and tells
   --  the task that ends the process. If that one has failed, the robot is
   --  stopped here, and the main procedure is told

end Failures;
