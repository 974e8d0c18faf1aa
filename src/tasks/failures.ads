--  SPDX-License-Identifier: GPL-3.0-or-later
--  Reaction to the end of a task, as none may end: the robot is stopped, then
--  the process.

with Texts;

package Failures with SPARK_Mode is

   procedure Wait_Stop_Failed;
   --  Waits until the task that ends the process has failed itself: the caller
   --  must end the process. For one task only

private

   procedure React (Line : Texts.Text; Of_Stop : Boolean);
   --  For the handler of Failures.Handlers, when a task has ended: puts Line
   --  into the log and tells the task that ends the process. If it was that
   --  one (Of_Stop), the robot is stopped here, and the main procedure is told

end Failures;
