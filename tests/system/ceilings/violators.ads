--  SPDX-License-Identifier: GPL-3.0-or-later
--  A task that calls an object whose ceiling is below its priority.

package Violators is

   procedure Await (Raised : out Boolean; Inside : out Integer);
   --  Waits until the task has called. Raised: it got Program_Error. Inside:
   --  its priority, as Linux has it, in an object whose ceiling is above its
   --  own, Schedule.Stop_Priority

end Violators;
