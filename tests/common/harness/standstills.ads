--  SPDX-License-Identifier: GPL-3.0-or-later
--  Detects stalls of this machine's processors, whatever their cause: the host
--  of a virtual machine or a limit on a container. A thread on each processor
--  wakes up every few milliseconds, with a priority above the supervisor's
--  and those of what drives it, if permitted.

with Instants; use Instants;

package Standstills is

   procedure Watch (Turn : Positive := 5; Lines : Boolean := False);
   --  Starts the measurement, until the end of the program: a look each Turn
   --  milliseconds. Lines: also a byte through a pseudo-terminal of its own.
   --  The kernel's threads that carry such bytes have no priority, and one
   --  list of work for all pseudo-terminals: what waits there, waits for all

   procedure Forget;
   --  Discards the measurements so far

   function Longest return Duration;
   --  The longest stall of a processor since Forget; 0.0 without Watch

   function Longest_Line return Duration;
   --  The longest that such a byte took since Forget, or has been under way

   procedure Tell
     (Since  : Instant;
      Action : not null access procedure (From, To : Instant));
   --  When a processor, or a byte, may have stood still since then: between
   --  two looks that were half a millisecond further apart than they should,
   --  or from a byte's sending to its arrival half a millisecond later or
   --  more. Only of the newest stalls, thousands of each

   function Taken_By_Host return Duration;
   --  Time that the host of a virtual machine has stolen from all processors
   --  together since boot, in steps of 10 ms; 0.0 if the kernel does not
   --  report it

   Too_Long : constant Duration := 0.02;
   Too_Much : constant Duration := 0.05;
   --  For a robot that has 80 ms to answer: the longest single stall, and the
   --  time taken by the host

   function Has_Stood_Still (Host : Duration) return Boolean;
   --  Since Forget, as long as one of these. Host: Taken_By_Host then

   procedure Await_Calm (Limit : Duration);
   --  Waits for a while without stalls, Limit at most; discards measurements

end Standstills;
