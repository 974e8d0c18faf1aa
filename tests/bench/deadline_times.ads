--  SPDX-License-Identifier: GPL-3.0-or-later
--  The deadlines from end to end: between the monitor's socket and the robot's
--  line, by the clock of both, beside the bounds of the analysis.

package Deadline_Times is

   procedure Report (Kept, Stood_Still : out Boolean);
   --  One supervisor all the time, under the load that the analysis takes for
   --  granted: robot's line at 9600 baud, watchdog, images with positions, an
   --  order at most every 50 ms, two busy loops that yield to all else. The
   --  monitor is lost every ten to twenty seconds, in each way in turn, and
   --  comes again. Kept: nothing
   --  was missed that is demanded of every single case; for how long the
   --  machine stood still meanwhile (Standstills) is taken out of each.
   --  Stood_Still: it did, for as long as Standstills.Too_Long, or its host
   --  took as much as Too_Much

end Deadline_Times;
