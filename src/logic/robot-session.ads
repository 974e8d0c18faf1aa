--  SPDX-License-Identifier: GPL-3.0-or-later
--  The session with the robot: what each request means in each state, as a
--  sequence of steps on the line. Decides; the owner of the line carries out.

with Robot.Health;
with Robot.Protocol;

package Robot.Session with SPARK_Mode is

   use type Robot.Protocol.Command;
   use type Robot.Protocol.Command_Kind;

   type Mode_Kind is (Not_Started, Started, Started_With_Watchdog);

   type State is record
      Line_Open : Boolean          := False;
      Mode      : Mode_Kind        := Not_Started;
      Health    : Robot.Health.State;
   end record;
   --  The initial state: line closed, robot not started

   function Is_Consistent (S : State) return Boolean is
     ((if not S.Line_Open then S.Mode = Not_Started)
      and then not Robot.Health.Lost (S.Health));
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

   subtype Movement is Robot.Protocol.Command
   with Dynamic_Predicate => Movement.Kind in Robot.Protocol.With_Argument;

   type Request is record
      Kind    : Request_Kind := Ping;
      Command : Movement     := Robot.Protocol.Stop;
      --  of Drive only
   end record;

   function Command_For (R : Request) return Robot.Protocol.Command is
     (case R.Kind is
         when Open_Line | Reset       => (Robot.Protocol.Reset, 0),
         when Start                   => (Robot.Protocol.Start, 0),
         when Start_Watchdog          => (Robot.Protocol.Start_Watchdog, 0),
         when Ping | Keep_Alive       => (Robot.Protocol.Ping, 0),
         when Power_Off               => (Robot.Protocol.Power_Off, 0),
         when Get_Battery             => (Robot.Protocol.Battery, 0),
         when Get_Moving              => (Robot.Protocol.Busy, 0),
         when Drive                   => R.Command,
         when Close_Line | Stop       => Robot.Protocol.Stop,
         when Reload | Reload_By_Hand => (Robot.Protocol.Reload, 0));
   --  What the robot is asked for

   function Changes_Session (Kind : Request_Kind) return Boolean is
     (Kind in Open_Line | Close_Line | Start | Start_Watchdog | Reset
        | Power_Off);
   --  These keep their place among the orders: all earlier ones come before
   --  them and all later ones after. Stops alone go past them

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
      Value : Robot.Protocol.Reply_Value := 0;
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
      Command : Robot.Protocol.Command := Robot.Protocol.Stop;
   end record;

   type Step_Result is record
      Ok    : Boolean := False;
      --  Open_Device: it is open; Exchange, Synchronise: a valid answer
      --  came in time, and Reply is it
      Reply : Robot.Protocol.Reply;
   end record;

   type Progress is private;
   --  How far a request has come

   function Result (P : Progress) return Outcome;
   --  What came of the request, once its step is Finish

   --  The words of the contracts

   function Is_Sent (Next : Step) return Boolean is
     (Next.Kind in Send | Exchange | Synchronise);
   --  The step writes its command to the line

   function Sends_Stop (Next : Step) return Boolean is
     (Is_Sent (Next) and then Next.Command = Robot.Protocol.Stop);

   function Sends_Movement (Next : Step) return Boolean is
     (Is_Sent (Next)
      and then Next.Command.Kind in Robot.Protocol.With_Argument
      and then Next.Command /= Robot.Protocol.Stop);

   function Sends_Reload (Next : Step) return Boolean is
     (Is_Sent (Next) and then Next.Command.Kind = Robot.Protocol.Reload);

   function Is_Reload_Active (S : State) return Boolean is
     (S.Mode = Started_With_Watchdog);
   --  The supervisor reloads the robot's watchdog

   function Is_Accepted (Last : Step_Result) return Boolean is
     (Last.Ok
      and then Last.Reply.Kind in
        Robot.Protocol.Done | Robot.Protocol.Level
        | Robot.Protocol.Moving_State);
   --  The robot acknowledged the step's command

   function Request_Of (P : Progress) return Request with Ghost;

   function Has_Stopped (P : Progress) return Boolean with Ghost;
   --  A step of this request has sent a stop

   function Is_Under_Way (S : State; P : Progress) return Boolean
   with Ghost;
   --  P belongs to S: the invariant of a request, true between its steps

   Max_Steps : constant := 17;

   function Steps_Left (S : State; P : Progress) return Natural with Ghost;
   --  At most so many steps are still to come; 0 once the outcome stands

   function Is_Allowed (S : State; P : Progress; Next : Step) return Boolean
   is
     --  no movement order except when started, and none after a stop
     ((if Sends_Movement (Next) then
          S.Mode /= Not_Started and then not Has_Stopped (P))
      --  the periodic reload exactly while it is active, one by hand
      --  exactly while it is not
      and then
        (if Sends_Reload (Next) then
            Request_Of (P).Kind =
              (if Is_Reload_Active (S) then Reload else Reload_By_Hand))
      --  nothing goes out on a closed line
      and then
        (if Is_Sent (Next) or else Next.Kind = Close_Device then S.Line_Open)
      --  an answer is awaited in step, a late one is skipped out of step
      and then
        (if Next.Kind = Exchange then Robot.Health.In_Step (S.Health)
         elsif Next.Kind = Synchronise then
            not Robot.Health.In_Step (S.Health)
            and then not Robot.Health.Lost (S.Health)
            and then Next.Command.Kind = Robot.Health.Probe (S.Health))
      --  what is written without awaiting an answer is a stop, and the
      --  reset of a line that has just been opened
      and then
        (if Next.Kind = Send then
            Sends_Stop (Next)
            or else (Next.Command.Kind = Robot.Protocol.Reset
                     and then Request_Of (P).Kind = Open_Line))
      and then
        (if Next.Kind = Finish then
            Is_Consistent (S) and then Steps_Left (S, P) = 0))
   with
     Ghost,
     Pre => Is_Under_Way (S, P);
   --  What holds of every step of every request

   --  The operations

   procedure Start_Request
     (S    : State;
      R    : Request;
      P    : out Progress;
      Next : out Step)
   with
     Pre  => Is_Consistent (S),
     Post => Is_Under_Way (S, P)
       and then Is_Allowed (S, P, Next)
       and then Request_Of (P) = R
       and then Has_Stopped (P) = Sends_Stop (Next)
       and then Steps_Left (S, P) <= Max_Steps
       and then (if R.Kind = Drive and then S.Mode = Not_Started
                 then Next.Kind = Finish)
       and then (if R.Kind = Reload
                 then (Next.Kind /= Finish) = Is_Reload_Active (S))
       and then (if not S.Line_Open
                 then Next.Kind in Open_Device | Finish);
   --  The first step of R

   procedure Continue_Request
     (S    : in out State;
      P    : in out Progress;
      Last : Step_Result;
      Next : out Step)
   with
     Pre  => Is_Under_Way (S, P),
     Post => Is_Under_Way (S, P)
       and then Is_Allowed (S, P, Next)
       and then Request_Of (P) = Request_Of (P'Old)
       and then Has_Stopped (P) =
                  (Has_Stopped (P'Old) or else Sends_Stop (Next))
       and then (Next.Kind = Finish
                 or else Steps_Left (S, P) < Steps_Left (S'Old, P'Old))
       --  started by an acknowledged start only
       and then
         (if S.Mode /= S'Old.Mode and then S.Mode /= Not_Started then
             Is_Accepted (Last)
             and then Next.Kind = Finish
             and then Result (P).Kind = Done
             and then Request_Of (P).Kind =
               (if S.Mode = Started then Start else Start_Watchdog))
       --  and no way out without a stop before
       and then
         (if S.Mode /= S'Old.Mode and then S.Mode = Not_Started then
             Has_Stopped (P'Old))
       --  a lost robot's line is closed
       and then
         (if Next.Kind = Finish and then Result (P).Note = Robot_Lost
          then not S.Line_Open);
   --  The next step of the same request, after its last step gave Last

private

   type Phase_Kind is
     (Opening,       --  the device
      Clearing,      --  the reset that follows an opening, and a probe
      Leaving,       --  the stop on the way out of "started"
      Acting,        --  the command that the request is for
      Asking_Motion, --  after a refused reload: does it move?
      Testing_Run,   --  it does not: does it still accept a stop?
      Closing,       --  the device
      Losing,        --  the last stop on a lost line
      Ended);

   Leave_Tries : constant := 3;
   --  How often the stop on the way out is tried while the line still works

   subtype Try_Count is Natural range 0 .. Leave_Tries;

   type Progress is record
      Request  : Robot.Session.Request;
      Phase    : Phase_Kind                  := Ended;
      Wanted   : Robot.Protocol.Command      := Robot.Protocol.Stop;
      --  the command of the phase's exchange
      Probing  : Robot.Protocol.Command_Kind := Robot.Protocol.Version;
      In_Probe : Boolean                     := False;
      --  the exchange under way only brings the line into step
      Blind    : Boolean                     := False;
      --  the stop has been sent once without being in step
      Stopped  : Boolean                     := False;
      --  a stop has been sent, in step or not
      Tries    : Try_Count                   := 0;
      Result   : Outcome;
   end record;

   function Result (P : Progress) return Outcome is (P.Result);

   function Request_Of (P : Progress) return Request is (P.Request);

   function Has_Stopped (P : Progress) return Boolean is (P.Stopped);

   subtype Exchange_Phase is Phase_Kind range Clearing .. Testing_Run;

   function May_Act (S : State; P : Progress) return Boolean is
     (case P.Request.Kind is
         when Open_Line                      => False,
         when Close_Line | Reset | Power_Off =>
           S.Mode = Not_Started or else P.Stopped,
         when Drive                          =>
           S.Mode /= Not_Started and then not P.Stopped,
         when Reload                         => Is_Reload_Active (S),
         when Reload_By_Hand                 => not Is_Reload_Active (S),
         when others                         => True)
   with Ghost;
   --  The request's own command may go out on the open line

   function Is_Exchanging (S : State; P : Progress) return Boolean is
     (P.Phase in Exchange_Phase
      and then S.Line_Open
      and then not Robot.Health.Lost (S.Health)
      and then
        (if P.In_Probe then not Robot.Health.In_Step (S.Health)
         elsif not Robot.Health.In_Step (S.Health) then
            P.Phase = Clearing
            or else (P.Blind and then P.Wanted = Robot.Protocol.Stop))
      and then
        (if P.Blind or else P.Wanted = Robot.Protocol.Stop
         then P.Stopped))
   with Ghost;
   --  A command of an exchange is out: the blind stop, the reset of a line
   --  just opened, a probe or the wanted one

   function Is_Under_Way (S : State; P : Progress) return Boolean is
     ((if P.Result.Note = Robot_Lost then
          P.Phase in Losing | Closing
          or else (P.Phase = Ended and then not S.Line_Open))
      and then
        (case P.Phase is
            when Ended   => Is_Consistent (S),
            when Opening =>
              P.Request.Kind = Open_Line
              and then not S.Line_Open
              and then not P.Blind
              and then Is_Consistent (S),
            when Losing  => S.Line_Open and then P.Stopped,
            when Closing => S.Mode = Not_Started or else P.Stopped,
            when Exchange_Phase =>
              Is_Exchanging (S, P)
              and then
                (case Exchange_Phase'(P.Phase) is
                    when Clearing      =>
                      P.Request.Kind = Open_Line
                      and then P.Wanted.Kind = Robot.Protocol.Reset,
                    when Leaving       =>
                      P.Wanted = Robot.Protocol.Stop
                      and then P.Request.Kind in
                        Close_Line | Reset | Power_Off,
                    when Acting        =>
                      P.Request.Kind /= Close_Line
                      and then P.Wanted = Command_For (P.Request)
                      and then
                        (May_Act (S, P)
                         or else P.Wanted = Robot.Protocol.Stop),
                    when Asking_Motion =>
                      P.Request.Kind = Reload
                      and then P.Wanted.Kind = Robot.Protocol.Busy,
                    when Testing_Run   =>
                      P.Request.Kind = Reload
                      and then P.Wanted = Robot.Protocol.Stop)));

   function Exchanges_Left (S : State; P : Progress) return Natural is
     (if P.In_Probe then 2
      elsif Robot.Health.In_Step (S.Health) then 1
      else 3)
   with Ghost;
   --  A blind stop, a probe, and the wanted command

   function Steps_Left (S : State; P : Progress) return Natural is
     (case P.Phase is
         when Ended                  => 0,
         when Closing                => 1,
         when Losing                 => 2,
         when Opening                => 6,
         when Clearing | Testing_Run => 2 + Exchanges_Left (S, P),
         when Asking_Motion          => 5 + Exchanges_Left (S, P),
         when Acting                 =>
           (if P.Request.Kind = Reload then 8 else 2)
           + Exchanges_Left (S, P),
         when Leaving                =>
           5 + 3 * (Leave_Tries - P.Tries) + Exchanges_Left (S, P));

end Robot.Session;
