--  SPDX-License-Identifier: GPL-3.0-or-later
--  What happens when a task ends, which none may: the process is told, and
--  stops the robot and itself.

package Failures with SPARK_Mode is

   pragma Elaborate_Body;
   --  Its elaboration sets the handler for all tasks, before any runs

   procedure Wait_Stop_Failed;
   --  Waits until the task that ends the process has failed itself, and
   --  leaves the end of the process to the caller. For one task only

end Failures;
