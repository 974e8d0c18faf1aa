--  SPDX-License-Identifier: GPL-3.0-or-later

package body Monitor.Session with SPARK_Mode is

   protected body State is

      procedure Get (Value : out Status) is
      begin
         Value := Current;
      end Get;

      procedure Begin_Active (Admitted : out Boolean) is
      begin
         Admitted := May_Follow (Current, Active);
         if Admitted then
            Current.Stage := Active;
         end if;
      end Begin_Active;

      procedure Go_On (To : Stage_Kind) is
      begin
         if May_Follow (Current, To) then
            Current.Stage := To;
         end if;
      end Go_On;

      procedure Stop is
      begin
         Current.Stopping := True;
      end Stop;

   end State;

end Monitor.Session;
