--  SPDX-License-Identifier: GPL-3.0-or-later

package body Monitor.Session with SPARK_Mode is

   protected body State is

      procedure Get (Value : out Monitor.Session_Stages.State) is
      begin
         Value := Current;
      end Get;

      procedure Begin_Active (Admitted : out Boolean) is
      begin
         Monitor.Session_Stages.Begin_Active (Current, Admitted);
      end Begin_Active;

      procedure Go_On (To : Monitor.Session_Stages.Stage_Kind) is
      begin
         Monitor.Session_Stages.Go_On (Current, To);
      end Go_On;

      procedure Stop is
      begin
         Monitor.Session_Stages.Stop (Current);
      end Stop;

   end State;

end Monitor.Session;
