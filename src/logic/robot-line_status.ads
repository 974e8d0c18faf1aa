--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the tasks know of the robot and its line, and when the line is to be
--  left free for the reload of the watchdog.

with Ada.Real_Time; use Ada.Real_Time;
with Robot.Health;
with Robot.Requests;
with Robot.Session;
with Schedule;

package Robot.Line_Status with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Robot.Line_Status);
   --  A claim that GNATprove checks: every subprogram ends

   use type Robot.Requests.Verdict_Kind;
   use type Robot.Session.Mode_Kind;
   use type Robot.Session.Outcome_Kind;

   type Status is record
      Open       : Boolean := False;
      Mode       : Robot.Session.Mode_Kind := Robot.Session.Not_Started;
      Epoch      : Natural := 0;
      --  another one after each start
      Started_At : Time := Time_First;
      --  when the robot acknowledged the last start
      Used_At    : Time := Time_First;
      --  the end of the last exchange
   end record;

   type State is record
      Known      : Status;
      Reload_Due : Time := Time_First;
      Suspect    : Boolean := False;
      --  the line has failed last
   end record;

   function Same_Run (Now, Before : Status) return Boolean is
     (Now.Mode /= Robot.Session.Not_Started
      and then Now.Epoch = Before.Epoch);
   --  The robot has been running since Before without a new start

   function Is_Quiet (S : State; Now : Time) return Boolean is
     (S.Known.Mode = Robot.Session.Started_With_Watchdog
      and then Now >= S.Reload_Due -
        (if S.Suspect then Schedule.Reload_Quiet_Suspect
         else Schedule.Reload_Quiet)
      and then Now < S.Reload_Due + Schedule.Reload_Quiet);
   --  Nothing but a stop or a movement is begun: a reload is due

   function Starts
     (Done : Robot.Requests.Job; Result : Robot.Session.Outcome)
     return Boolean
   is (Done.Verdict = Robot.Requests.Carry_Out
       and then Done.Request.Kind in
         Robot.Session.Start | Robot.Session.Start_Watchdog
       and then Result.Kind = Robot.Session.Done);
   --  The robot has begun to run

   procedure Note
     (S       : in out State;
      Done    : Robot.Requests.Job;
      Session : Robot.Session.State;
      Result  : Robot.Session.Outcome;
      Now     : Time)
   with
     Post => S.Known.Open = Session.Line_Open
       and then S.Known.Mode = Session.Mode
       and then S.Suspect = (Robot.Health.Failures (Session.Health) > 0)
       and then (S.Known.Epoch /= S'Old.Known.Epoch) = Starts (Done, Result);
   --  Result has come of Done just now, and Session is its state

end Robot.Line_Status;
