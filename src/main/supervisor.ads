--  SPDX-License-Identifier: GPL-3.0-or-later
--  The supervisor: reads the command line, logs its configuration, and runs
--  the tasks until the process ends.

package Supervisor with SPARK_Mode is

   procedure Run;
   --  Does not return: the process ends. For the environment task

end Supervisor;
