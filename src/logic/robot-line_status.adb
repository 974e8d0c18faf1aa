--  SPDX-License-Identifier: GPL-3.0-or-later

package body Robot.Line_Status with SPARK_Mode is

   procedure Note
     (S       : in out State;
      Done    : Robot.Requests.Job;
      Session : Robot.Session.State;
      Result  : Robot.Session.Outcome;
      Now     : Time) is
   begin
      S.Suspect := Robot.Health.Failures (Session.Health) > 0;
      S.Known.Open := Session.Line_Open;
      S.Known.Mode := Session.Mode;
      S.Known.Used_At := Now;
      if Starts (Done, Result) then
         S.Known.Epoch :=
           (if S.Known.Epoch = Natural'Last then 0 else S.Known.Epoch + 1);
         S.Known.Started_At := Now;
         S.Reload_Due := Now + Schedule.Reload_Period;
      end if;
      if Is_Refused_Reload (Done, Result) then
         S.Known.Reloads_Refused :=
           (if S.Known.Reloads_Refused = Natural'Last then 0
            else S.Known.Reloads_Refused + 1);
      end if;
   end Note;

end Robot.Line_Status;
