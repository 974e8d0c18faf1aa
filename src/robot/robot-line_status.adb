--  SPDX-License-Identifier: GPL-3.0-or-later

package body Robot.Line_Status with SPARK_Mode is

   function Next_Due (Due, Now : Time; Period : Time_Span) return Time is
     (if Due + Period > Now then Due + Period else Now + Period);
   --  A period after Due; periods that could not be kept are left out, not
   --  caught up with

   procedure Note
     (S      : in out Status;
      Done   : Requests.Job;
      Held   : Dialogue;
      Result : Commands.Outcome;
      Now    : Time) is
   begin
      S.Held := Held;
      S.Used_At := Now;
      if Starts (Done, Result) then
         S.Epoch := (if S.Epoch = Natural'Last then 0 else S.Epoch + 1);
         S.Unanswered := 0;
         S.Reload_Due := Held.Counted + Schedule.Reload_Period;
         S.Battery_Due := Held.Counted + Schedule.Battery_Offset;
      elsif Done.From = Requests.Reload then
         S.Unanswered :=
           (if Result.Kind = Commands.Timed_Out then
               Unanswered_Count'Min (S.Unanswered, 1) + 1
            else 0);
         if Held.Counted > S.Reload_Due + Schedule.Reload_Quiet then
            --  the line was not free
            S.Reload_Due := Held.Counted;
         end if;
         S.Reload_Due := Next_Due
           (S.Reload_Due, Now, Milliseconds (Interval_After (S.Unanswered)));
      elsif Done.From = Requests.Battery then
         S.Battery_Due :=
           Next_Due (S.Battery_Due, Now, Schedule.Battery_Period);
      end if;
   end Note;

end Robot.Line_Status;
