--  SPDX-License-Identifier: GPL-3.0-or-later
--  The supervisor: reads the command line, says what it will do, and lets
--  its tasks work until the process is ended.

package Supervisor with SPARK_Mode is

   procedure Run;
   --  Does not return: the process ends instead. For the environment task

end Supervisor;
