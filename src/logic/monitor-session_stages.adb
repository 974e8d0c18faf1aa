--  SPDX-License-Identifier: GPL-3.0-or-later

package body Monitor.Session_Stages with SPARK_Mode is

   procedure Begin_Active (S : in out State; Admitted : out Boolean) is
   begin
      Admitted := May_Begin (S);
      if Admitted then
         S.Stage := Active;
      end if;
   end Begin_Active;

   procedure Go_On (S : in out State; To : Stage_Kind) is
   begin
      if After (S.Stage) = To then
         S.Stage := To;
      end if;
   end Go_On;

   procedure Stop (S : in out State) is
   begin
      S.Stopping := True;
   end Stop;

end Monitor.Session_Stages;
