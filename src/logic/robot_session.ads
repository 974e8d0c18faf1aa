--  SPDX-License-Identifier: GPL-3.0-or-later
--  The session with the robot: what each request means in each state, as a
--  sequence of steps on the line. Decides; the owner of the line carries out.

with Line_Health;
with Robot_Protocol;

package Robot_Session with SPARK_Mode is

   use type Robot_Protocol.Command;
   use type Robot_Protocol.Command_Kind;

   type Mode_Kind is (Not_Started, Started, Started_With_Watchdog);

   type State is record
      Line_Open : Boolean          := False;
      Mode      : Mode_Kind        := Not_Started;
      Health    : Line_Health.State;
   end record;
   --  The initial state: line closed, robot not started

   function Is_Consistent (S : State) return Boolean is
     ((if not S.Line_Open then S.Mode = Not_Started)
      and then not Line_Health.Lost (S.Health));
   --  A started robot has an open line; a lost line is never kept open

   type Request_Kind is
     (Open_Line,        --  then a reset brings the robot to a known state
      Close_Line,       --  stops a started robot first
      Start,            --  without watchdog
      Start_Watchdog,
      Reset,            --  stops a started robot first
      Ping,
      Power_Off,        --  stops a started robot first
      Get_Battery,
      Get_Moving,
      Drive,            --  a movement order: only while started
      Stop,             --  always sent while the line is open
      Reload,           --  the periodic reload of the watchdog
      Reload_By_Hand,   --  a monitor's: nothing to send during the periodic
      Keep_Alive);      --  a ping that finds a lost line

   type Request is record
      Kind    : Request_Kind            := Ping;
      Command : Robot_Protocol.Command  := Robot_Protocol.Stop;
      --  of Drive only
   end record;

   type Outcome_Kind is
     (Done,             --  the robot acknowledged, or nothing was to be done
      Refused,          --  the robot refused it, or would have
      Timed_Out,        --  no valid answer
      Not_Open,         --  the line is not open
      Not_Opened);      --  the device cannot be opened

   type Note_Kind is
     (Nothing,
      Missed_Window,    --  a reload was refused, the robot runs on
      Not_Running,      --  a reload was refused: the robot runs no longer
      Robot_Lost);      --  the fourth failure in a row: the line is closed

   type Outcome is record
      Kind  : Outcome_Kind := Done;
      Value : Robot_Protocol.Reply_Value := 0;
      --  of Get_Battery (0 .. 2) and Get_Moving (0, 1), when Done
      Note  : Note_Kind := Nothing;
   end record;

   type Step_Kind is
     (Open_Device,
      Close_Device,
      Send,        --  write the command, await nothing
      Exchange,    --  write the command, await its answer
      Synchronise, --  the same, and skip the frames of other classes
      Finish);     --  the outcome stands

   type Step is record
      Kind    : Step_Kind              := Finish;
      Command : Robot_Protocol.Command := Robot_Protocol.Stop;
   end record;

   type Step_Result is record
      Ok    : Boolean := False;
      --  Open_Device: it is open; Exchange, Synchronise: a valid answer
      --  came in time, and Reply is it
      Reply : Robot_Protocol.Reply;
   end record;

   type Progress is private;
   --  How far a request has come

   function Result (P : Progress) return Outcome;
   --  What came of the request, once its step is Finish

   procedure Start_Request
     (S    : State;
      R    : Request;
      P    : out Progress;
      Next : out Step)
   with
     Pre  => Is_Consistent (S),
     Post =>
       (if R.Kind = Drive and then S.Mode = Not_Started
        then Next.Kind = Finish)
       and then (if not S.Line_Open
                 then Next.Kind in Open_Device | Finish);
   --  The first step of R. No movement order leaves except when started

   procedure Continue_Request
     (S      : in out State;
      P      : in out Progress;
      Last   : Step_Result;
      Next   : out Step);
   --  The next step of the same request, after its last step gave Last.
   --  At most 20 steps make a request

private

   type Phase_Kind is
     (Opening,       --  the device
      Clearing,      --  the reset that follows an opening
      Leaving,       --  the stop on the way out of "started"
      Acting,        --  the command that the request is for
      Asking_Motion, --  after a refused reload: does it move?
      Testing_Run,   --  it does not: does it still accept a stop?
      Closing,       --  the device
      Losing,        --  the last stop on a lost line
      Ended);

   subtype Try_Count is Natural range 0 .. 3;

   type Progress is record
      Request : Robot_Session.Request;
      Phase   : Phase_Kind             := Ended;
      Wanted  : Robot_Protocol.Command := Robot_Protocol.Stop;
      --  the command of the phase's exchange
      Probing : Robot_Protocol.Command_Kind := Robot_Protocol.Version;
      In_Probe : Boolean               := False;
      --  the exchange under way only brings the line into step
      Blind   : Boolean                := False;
      --  the stop has been sent once without being in step
      Tries   : Try_Count              := 0;
      Result  : Outcome;
   end record;

   function Result (P : Progress) return Outcome is (P.Result);

end Robot_Session;
