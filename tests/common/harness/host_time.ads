--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the host of a virtual machine takes for others: nothing of that
--  time is a program's own doing.

package Host_Time is

   function Taken return Duration;
   --  From all processors together since the machine was started, in steps
   --  of 10 ms; 0.0 where the kernel does not say

end Host_Time;
