--  SPDX-License-Identifier: GPL-3.0-or-later
--  How long this machine's processors stood still, whoever stopped them: the
--  host of a virtual machine or a limit on a container. Seen by a thread on
--  each processor that wants to run every few milliseconds, above all of the
--  supervisor's priorities where that is allowed.

package Standstills is

   procedure Watch;
   --  From now on, as long as the program runs

   procedure Forget;
   --  What was seen until now

   function Longest return Duration;
   --  Of any processor since the last Forget; 0.0 without Watch

end Standstills;
