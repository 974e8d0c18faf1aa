--  SPDX-License-Identifier: GPL-3.0-or-later
--  What happens when a task ends, which none may: the process is told, and
--  stops the robot and itself.

package Failures with
  SPARK_Mode,
  Abstract_State => (Stop_Task with Synchronous),
  Initializes    => Stop_Task
is

   pragma Elaborate_Body;
   --  Its elaboration sets the handler for all tasks, before any runs

   procedure Get_Stop_Failed (Failed : out Boolean)
   with Global => (In_Out => Stop_Task);
   --  Whether Wait_Stop_Failed would return at once

   procedure Wait_Stop_Failed with Global => (In_Out => Stop_Task);
   --  Waits until the task that ends the process has failed itself, and
   --  leaves the end of the process to the caller. For one task only

end Failures;
