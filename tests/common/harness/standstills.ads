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

   Too_Long : constant Duration := 0.02;
   Too_Much : constant Duration := 0.05;
   --  For a robot that has 80 ms to answer: to stand still in one piece, and
   --  what the host takes of all processors together (Host_Time)

   procedure Await_Calm (Limit : Duration);
   --  Until there has been neither for a while, Limit at most; forgets

end Standstills;
