--  SPDX-License-Identifier: GPL-3.0-or-later
--  Reaction to the end of a task, as none may end: the robot is stopped, then
--  the process.

package Failures with
  SPARK_Mode,
  Abstract_State => (Stop_Task with Synchronous),
  Initializes    => Stop_Task
is

   pragma Elaborate_Body;
   --  The elaboration sets the handler for all tasks, before any runs

   procedure Get_Stop_Failed (Failed : out Boolean)
   with Global => (In_Out => Stop_Task);
   --  Whether Wait_Stop_Failed would return at once

   procedure Wait_Stop_Failed with Global => (In_Out => Stop_Task);
   --  Waits until the task that ends the process has failed itself: the caller
   --  must end the process. For one task only

end Failures;
