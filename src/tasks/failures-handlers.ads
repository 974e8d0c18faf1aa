--  SPDX-License-Identifier: GPL-3.0-or-later
--  The handler for the end of any task. The run time calls it.

private package Failures.Handlers with SPARK_Mode is

   pragma Elaborate_Body;
   --  The elaboration sets the handler for all tasks, before any runs

end Failures.Handlers;
