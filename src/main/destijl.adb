--  SPDX-License-Identifier: GPL-3.0-or-later
--  The supervisor's main procedure.

with Ada.Exceptions;
with Console;
with Process.Signals;
with Schedule;
with Supervisor;

procedure Destijl with SPARK_Mode => Off, Priority => Schedule.Main_Priority
is
   --  Off: an exception handler, for what proof does not cover (hardware
   --  signals, stack overflow)
begin
   Supervisor.Run;
exception
   when E : others =>
      Console.Put_Log
        ("destijl: internal failure: "
         & Ada.Exceptions.Exception_Information (E));
      Process.Signals.Report_Failure;
end Destijl;
