--  SPDX-License-Identifier: GPL-3.0-or-later
--  Time that the host of a virtual machine has stolen: no program here is its
--  cause.

package Host_Time is

   function Taken return Duration;
   --  Of all processors together since boot, in steps of 10 ms; 0.0 if the
   --  kernel does not report it

end Host_Time;
