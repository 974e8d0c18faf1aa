--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the command line asks for and no task is needed for: the usage, the
--  version, or what is wrong with it. It is answered where this package is
--  elaborated, before the tasks start; then the process ends.

package Early_Answers with SPARK_Mode is

   pragma Elaborate_Body;

end Early_Answers;
