--  SPDX-License-Identifier: GPL-3.0-or-later
--  The session with the robot: what each request means in each state, as a
--  sequence of steps, which the task that has the line carries out.

with Commands; use Commands;
with Robot.Health;
with Robot.Protocol;

package Robot.Session with SPARK_Mode is

   use type Protocol.Command;
   use type Protocol.Command_Kind;

   type Mode_Kind is (Not_Started, Started, Started_With_Watchdog);

   type State is record
      Line_Open : Boolean          := False;
      Mode      : Mode_Kind        := Not_Started;
      Idle      : Boolean          := False;
      --  the robot is known not to run: it has acknowledged a reset, and no
      --  start has been sent since
      Health    : Robot.Health.State;
   end record;
   --  The initial state: line closed, robot not started

   function Is_Consistent (S : State) return Boolean is
     ((if S.Idle or else not S.Line_Open then S.Mode = Not_Started)
      and then not Health.Lost (S.Health));
   --  A started robot has an open line; a lost line is always closed

   function Command_For (R : Request) return Protocol.Command is
     (case R.Kind is
         when Open_Line | Reset       => (Protocol.Reset, 0),
         when Start                   => (Protocol.Start, 0),
         when Start_Watchdog          => (Protocol.Start_Watchdog, 0),
         when Ping | Keep_Alive       => (Protocol.Ping, 0),
         when Power_Off               => (Protocol.Power_Off, 0),
         when Get_Battery             => (Protocol.Battery, 0),
         when Get_Version             => (Protocol.Version, 0),
         when Get_Moving              => (Protocol.Busy, 0),
         when Drive                   =>
           ((if R.Command.Kind = Move then Protocol.Move else Protocol.Turn),
            R.Command.Value),
         when Close_Line | Stop       => Protocol.Stop,
         when Reload | Reload_By_Hand => (Protocol.Reload, 0));
   --  The robot's command for R

   function Changes_Session (Kind : Request_Kind) return Boolean is
     (Kind in Open_Line | Close_Line | Start | Start_Watchdog | Reset
        | Power_Off);
   --  All earlier orders are carried out before these, and all later ones
   --  after. Only stops overtake them

   type Step_Kind is
     (Open_Device,
      Close_Device,
      Send,      --  write the command, await no answer
      Exchange,  --  write the command, await its answer
      Finish);   --  the outcome is final
   --  Out of step (Robot.Health) an exchange skips the frames of other classes

   type Step is record
      Kind    : Step_Kind        := Finish;
      Command : Protocol.Command := Protocol.Stop;
   end record;

   type Step_Result is record
      Ok    : Boolean := False;
      --  Open_Device: it is open; Exchange: a valid answer came in time,
      --  which is Reply
      Reply : Protocol.Reply;
      Text  : Commands.Answer_Text;
      --  of the reply's frame
   end record;

   type Phase_Kind is
     (Opening,       --  the device
      Clearing,      --  the reset after opening, and a probe
      Leaving,       --  the stop before leaving "started"
      Acting,        --  the command of the request itself
      Asking_Motion, --  after a refused reload: does it move?
      Testing_Run,   --  it does not, or has refused a movement or a stop: does
                     --  it still accept a stop?
      Closing,       --  the device
      Losing,        --  the last stop on a lost line
      Ended);

   Leave_Tries : constant := 3;
   --  Attempts of the stop before leaving, while the line works

   type Progress is record
      Request  : Commands.Request;
      Phase    : Phase_Kind       := Ended;
      Wanted   : Protocol.Command := Protocol.Stop;
      --  the command of the phase's exchange
      In_Probe : Boolean          := False;
      --  the current exchange only synchronises the line
      Blind    : Boolean          := False;
      --  the stop has been sent once while out of step
      Stopped  : Boolean          := False;
      --  a stop has been sent, in step or not
      Tries    : Natural range 0 .. Leave_Tries := 0;
      Off_Sent : Boolean          := False;
      --  Power_Off has been sent, and was not answered
      Result   : Outcome;
      --  once it has Ended
   end record;
   --  The progress of a request

   function Is_Sent (Next : Step) return Boolean is
     (Next.Kind in Send | Exchange);
   --  The step writes its command to the line

   function Sends_Stop (Next : Step) return Boolean is
     (Is_Sent (Next) and then Next.Command = Protocol.Stop);

   function Sends_Movement (Next : Step) return Boolean is
     (Is_Sent (Next) and then Protocol.Is_Movement (Next.Command));

   function Is_Accepted (Last : Step_Result) return Boolean is
     (Last.Ok and then Last.Reply.Kind in Protocol.Accepted_Reply);
   --  The robot acknowledged the step's command

   subtype Exchange_Phase is Phase_Kind range Clearing .. Testing_Run;

   function May_Act (S : State; P : Progress) return Boolean is
     (P.Request.Kind not in Open_Line | Close_Line
      and then
        (if P.Request.Kind in Reset | Power_Off then
            S.Mode = Not_Started or else P.Stopped)
      and then
        (if Protocol.Is_Movement (P.Wanted) then
            S.Mode /= Not_Started and then not P.Stopped)
      and then
        (if P.Wanted.Kind = Protocol.Reload then
            (P.Request.Kind = Reload) = (S.Mode = Started_With_Watchdog)))
   with Ghost;
   --  The request's own command may be sent on the open line

   function Is_Exchanging (S : State; P : Progress) return Boolean is
     (S.Line_Open
      and then not Health.Lost (S.Health)
      and then
        (if P.In_Probe then not Health.In_Step (S.Health)
         elsif not Health.In_Step (S.Health) then
            P.Phase = Clearing
            or else (P.Blind and then P.Wanted = Protocol.Stop))
      and then
        (if P.Blind or else P.Wanted = Protocol.Stop then P.Stopped))
   with Ghost;
   --  A command of an exchange has been sent: the blind stop, the reset of a
   --  newly opened line, a probe or the wanted one

   function Is_Under_Way (S : State; P : Progress) return Boolean is
     ((if P.Result.Note = Robot_Lost then
          P.Phase in Losing | Closing
          or else (P.Phase = Ended and then not S.Line_Open))
      and then (if S.Idle then S.Mode = Not_Started)
      and then
        (case P.Phase is
            when Ended   => Is_Consistent (S),
            when Opening =>
              P.Request.Kind = Open_Line
              and then not S.Line_Open
              and then not P.Blind
              and then Is_Consistent (S),
            when Losing  => S.Line_Open and then P.Stopped,
            when Closing =>
              S.Line_Open and then (S.Mode = Not_Started or else P.Stopped),
            when Exchange_Phase =>
              Is_Exchanging (S, P)
              and then
                (case Exchange_Phase'(P.Phase) is
                    when Clearing      =>
                      P.Request.Kind = Open_Line
                      and then S.Mode = Not_Started
                      and then P.Wanted.Kind = Protocol.Reset,
                    when Leaving       =>
                      P.Wanted = Protocol.Stop
                      and then P.Request.Kind in
                        Close_Line | Reset | Power_Off,
                    when Acting        =>
                      P.Wanted = Command_For (P.Request)
                      and then May_Act (S, P),
                    when Asking_Motion =>
                      P.Request.Kind = Reload
                      and then P.Wanted.Kind = Protocol.Busy,
                    when Testing_Run   =>
                      P.Request.Kind in Reload | Drive | Stop
                      and then P.Wanted = Protocol.Stop)))
   with Ghost;
   --  P belongs to S: the invariant of a request, valid between its steps. The
   --  line of a lost robot is closed

   Max_Steps : constant := 19;

   function Exchanges_Left (S : State; P : Progress) return Natural is
     (if P.In_Probe then 2 elsif Health.In_Step (S.Health) then 1 else 3)
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
           (case P.Request.Kind is
               when Reload       => 8,
               when Drive | Stop => 5,
               when Power_Off    => (if P.Off_Sent then 2 else 4),
               when others       => 2)
           + Exchanges_Left (S, P),
         when Leaving                =>
           7 + 3 * (Leave_Tries - P.Tries) + Exchanges_Left (S, P))
   with Ghost;
   --  Upper bound of the remaining steps; 0 once the outcome is final

   function Is_Allowed (S : State; P : Progress; Next : Step) return Boolean
   is
     --  a movement is sent only while started, and never after a stop
     ((if Sends_Movement (Next) then
          S.Mode /= Not_Started and then not P.Stopped)
      --  the periodic reload is sent only while started with watchdog, a
      --  monitor's only while not
      and then
        (if Is_Sent (Next) and then Next.Command.Kind = Protocol.Reload then
            P.Request.Kind = (if S.Mode = Started_With_Watchdog then Reload
                              else Reload_By_Hand))
      --  nothing is sent on a closed line
      and then
        (if Is_Sent (Next) or else Next.Kind = Close_Device then S.Line_Open)
      --  out of step: only the probe's answer is awaited
      and then
        (if Next.Kind = Exchange then
            not Health.Lost (S.Health)
            and then
              (if not Health.In_Step (S.Health) then
                  Next.Command.Kind = Health.Probe (S.Health)))
      --  only a stop, and the reset of a newly opened line, are sent without
      --  awaiting an answer
      and then
        (if Next.Kind = Send then
            Sends_Stop (Next)
            or else (Next.Command.Kind = Protocol.Reset
                     and then P.Request.Kind = Open_Line))
      and then (if Next.Kind = Finish then Is_Consistent (S)))
   with Ghost;

   function Next_Step (S : State; P : Progress) return Step is
     (case P.Phase is
         when Opening        => (Open_Device, Protocol.Stop),
         when Closing        => (Close_Device, Protocol.Stop),
         when Losing         => (Send, Protocol.Stop),
         when Ended          => (Finish, Protocol.Stop),
         when Exchange_Phase =>
           (if P.In_Probe then (Exchange, (Health.Probe (S.Health), 0))
            elsif Health.In_Step (S.Health) then (Exchange, P.Wanted)
            else (Send, P.Wanted)))
   with
     Pre  => Is_Under_Way (S, P),
     Post => Is_Allowed (S, P, Next_Step'Result);
   --  Of every request. A probe does what is harmless, and has an answer of a
   --  class that is not owed (Robot.Health)

   procedure Start_Request (S : State; R : Request; P : out Progress)
   with
     Pre  => Is_Consistent (S),
     Post => Is_Under_Way (S, P)
       and then P.Request = R
       and then P.Stopped = Sends_Stop (Next_Step (S, P))
       and then Steps_Left (S, P) <= Max_Steps
       and then (if R.Kind = Reload then
                   (P.Phase /= Ended) = (S.Mode = Started_With_Watchdog));
   --  Up to the first step of R

   function Is_Mode_Change
     (S : State; P, Before : Progress; Last : Step_Result) return Boolean
   is (if S.Mode = Not_Started then Before.Stopped
       else Is_Accepted (Last)
         and then P.Phase = Ended
         and then P.Result.Kind = Done
         and then P.Request.Kind =
           (if S.Mode = Started then Start else Start_Watchdog))
   with Ghost;
   --  Started only by an acknowledged start, never left without a stop before

   procedure Continue_Request
     (S : in out State; P : in out Progress; Last : Step_Result)
   with
     Pre  => Is_Under_Way (S, P),
     Post => Is_Under_Way (S, P)
       and then P.Request = P'Old.Request
       and then P.Stopped =
                  (P'Old.Stopped or else Sends_Stop (Next_Step (S, P)))
       and then (P.Phase = Ended
                 or else Steps_Left (S, P) < Steps_Left (S'Old, P'Old))
       and then (S.Mode = S'Old.Mode
                 or else Is_Mode_Change (S, P, P'Old, Last));
   --  Up to the next step of the same request, after its last step gave Last

end Robot.Session;
