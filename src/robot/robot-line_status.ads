--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the tasks know of the robot and its line, and when the periodic
--  requests are due.

with Ada.Real_Time; use Ada.Real_Time;
with Commands;
with Robot.Requests;
with Robot.Session;
with Schedule;

package Robot.Line_Status with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Robot.Line_Status);  --  proved

   use type Requests.Source;
   use type Session.Mode_Kind;
   use type Commands.Outcome_Kind;
   use type Commands.Request_Kind;

   type Dialogue is record
      State   : Session.State;
      Counted : Time := Time_First;
      --  when the last start or reload was sent: the robot's watchdog counts
      --  from there
      Empty   : Boolean := False;
      --  the robot's battery, when last asked
      Unasked : Natural range 0 .. 6 := 0;
      --  two more for each command before which the line's device sent without
      --  being asked, one less for each other. Noise does not last; at 5 it is
      --  no robot, and it has not started unless it is 0
      Told    : Boolean := False;
      --  the log says, once each time the line is open, that it does so
      Gone    : Boolean := False;
      --  the line's device has been removed since it was opened
   end record
   with Dynamic_Predicate => Robot.Session.Is_Consistent (Dialogue.State);
   --  What the task that has the line knows of the robot

   --  How long after a reload of the watchdog the next is due. The robot
   --  counts ticks of 100 ms, accepts a reload at 9 to 11 of them, and counts
   --  anew at the 12th, a miss, or after a reload. If a reload has no answer,
   --  either it or its answer was lost: the next must be right in both cases

   subtype Unanswered_Count is Natural range 0 .. 2;
   --  Reloads without an answer in a row; 2: or more

   function Interval_After (Unanswered : Unanswered_Count) return Positive is
     (case Unanswered is
         when 0 => Schedule.Reload_Ms,
         when 1 => Schedule.First_Retry_Ms,
         when 2 => Schedule.Next_Retry_Ms);
   --  Milliseconds from this reload to the next

   type Status is record
      Held        : Dialogue;
      --  as the last task left it that had the line
      Used_At     : Time := Time_First;
      --  when that was
      Epoch       : Natural := 0;
      --  changes at each start
      Reload_Due  : Time := Time_Last;
      Battery_Due : Time := Time_Last;
      Unanswered  : Unanswered_Count := 0;
      --  reloads
   end record;

   Max_Idle_Failures : constant := 2;
   --  A robot that is not started and has left as many pings without an answer
   --  is off, and is asked no more: its line stays open

   function Mode (S : Status) return Session.Mode_Kind is (S.Held.State.Mode);

   function Same_Run (Now, Before : Status) return Boolean is
     (Mode (Now) /= Session.Not_Started and then Now.Epoch = Before.Epoch);
   --  The robot has run since Before without a restart

   function Due (S : Status; From : Requests.Periodic) return Time is
     (case From is
         when Requests.Reload     =>
           (if Mode (S) = Session.Started_With_Watchdog then S.Reload_Due
            else Time_Last),
         when Requests.Battery    =>
           (if Mode (S) /= Session.Not_Started then S.Battery_Due
            else Time_Last),
         when Requests.Keep_Alive =>
           (if Mode (S) /= Session.Not_Started
            then S.Used_At + Schedule.Keep_Alive_Period
            elsif S.Held.State.Line_Open
              and then S.Held.State.Health.Failures < Max_Idle_Failures
            then S.Used_At + Schedule.Idle_Ping_Period
            else Time_Last));
   --  Time_Last: as it is now, never

   function Is_Quiet
     (S : Status; Now : Time; Answer_Timeout : Time_Span) return Boolean
   is
     (Mode (S) = Session.Started_With_Watchdog
      and then Now >= S.Reload_Due -
        (if S.Held.State.Health.Failures > 0 then
            Answer_Timeout + Schedule.Reload_Quiet_Suspect
         else Schedule.Reload_Quiet));
   --  A reload is due: only a stop or a movement may start

   function Starts
     (Done : Requests.Job; Result : Commands.Outcome) return Boolean
   is (Done.Request.Kind in Commands.Start | Commands.Start_Watchdog
       and then Result.Kind = Commands.Done);
   --  The robot has started

   procedure Note
     (S      : in out Status;
      Done   : Requests.Job;
      Held   : Dialogue;
      Result : Commands.Outcome;
      Now    : Time)
   with Post => (S.Epoch /= S.Epoch'Old) = Starts (Done, Result);
   --  Request Done has just ended with Result, the robot's dialogue as in Held

end Robot.Line_Status;
