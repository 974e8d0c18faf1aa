--  SPDX-License-Identifier: GPL-3.0-or-later

package body Robot.Line_Status with SPARK_Mode is

   procedure Note
     (S      : in out State;
      Done   : Robot.Requests.Job;
      Held   : Dialogue;
      Result : Robot.Session.Outcome;
      Now    : Time) is
   begin
      S.Known.Failures := Robot.Health.Failures (Held.State.Health);
      S.Known.Open := Held.State.Line_Open;
      S.Known.Mode := Held.State.Mode;
      S.Known.Used_At := Now;
      S.Known.Counts_From := Held.Counted;
      if Starts (Done, Result) then
         S.Known.Epoch :=
           (if S.Known.Epoch = Natural'Last then 0 else S.Known.Epoch + 1);
         S.Reload_Due := Held.Counted + Schedule.Reload_Period;
      end if;
      if Is_Refused_Reload (Done, Result) then
         S.Known.Reloads_Refused :=
           (if S.Known.Reloads_Refused = Natural'Last then 0
            else S.Known.Reloads_Refused + 1);
      end if;
   end Note;

end Robot.Line_Status;
