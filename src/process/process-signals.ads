--  SPDX-License-Identifier: GPL-3.0-or-later
--  The signals that end the process. They are blocked before any task runs.

with Trace;

package Process.Signals with SPARK_Mode is

   pragma Elaborate_Body;

   type Kind is
     (Stop_Request,
      --  any that would end or stop the process otherwise, such as SIGTERM,
      --  SIGQUIT or SIGTSTP. SIGHUP stays ignored if it was (nohup)
      Failure);
      --  Report_Failure

   procedure Wait (Signal : out Kind)
   with Global => (In_Out => (System_State, Trace.Recorder));
   --  Waits for one. For th_stop only

   procedure Report_Failure with Global => (In_Out => System_State);
   --  Makes Wait return Failure; never waits

end Process.Signals;
