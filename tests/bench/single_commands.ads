--  SPDX-License-Identifier: GPL-3.0-or-later
--  What a session seldom has: every command by itself, newcomers who are
--  turned away, monitors that are lost, and the orderly stop.

package Single_Commands is

   procedure Measure_Tasks;
   --  Adds to Task_Times what the tasks take for it, with two busy loops, in
   --  one supervisor after the other, about Bench_Settings.Seconds in all

end Single_Commands;
