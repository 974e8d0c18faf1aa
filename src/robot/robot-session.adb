--  SPDX-License-Identifier: GPL-3.0-or-later

package body Robot.Session with SPARK_Mode is

   package Wire renames Robot.Protocol;

   procedure Begin_Exchange
     (S       : State;
      P       : in out Progress;
      Phase   : Phase_Kind;
      Command : Wire.Command;
      Next    : out Step)
   is
      --  The step that exchanges Command in Phase. If the line is out of step,
      --  a probe comes first, and before the probe a blind stop
   begin
      P.Phase  := Phase;
      P.Wanted := Command;
      P.In_Probe := False;
      if Robot.Health.In_Step (S.Health) then
         P.Stopped := P.Stopped or else Command = Wire.Stop;
         Next := (Exchange, Command);
      elsif Command = Wire.Stop and then not P.Blind then
         P.Blind := True;
         P.Stopped := True;
         Next := (Send, Command);
      else
         P.In_Probe := True;
         Next := (Synchronise, (Robot.Health.Probe (S.Health), Value => 0));
      end if;
   end Begin_Exchange;

   procedure Finish
     (P    : in out Progress;
      Kind : Outcome_Kind;
      Next : out Step)
   is
      --  Ends the request
   begin
      P.Phase := Ended;
      P.Result.Kind := Kind;
      Next := (Finish, Wire.Stop);
   end Finish;

   procedure Act
     (S    : State;
      P    : in out Progress;
      Next : out Step)
   is
      --  The command of the request, after the stop if one was due
   begin
      case P.Request.Kind is
         when Open_Line =>
            P.Phase := Opening;
            Next := (Open_Device, Wire.Stop);
         when Close_Line =>
            P.Phase := Closing;
            Next := (Close_Device, Wire.Stop);
         when others =>
            Begin_Exchange (S, P, Acting, Command_For (P.Request), Next);
      end case;
   end Act;

   procedure Start_Request
     (S    : State;
      R    : Request;
      P    : out Progress;
      Next : out Step)
   is
   begin
      P := (Request => R, others => <>);
      if not S.Line_Open and then R.Kind not in Open_Line | Close_Line then
         Finish (P, Not_Open, Next);
      elsif (R.Kind = Open_Line and then S.Line_Open)
        or else (R.Kind = Close_Line and then not S.Line_Open)
        or else (R.Kind = Reload and then S.Mode /= Started_With_Watchdog)
        or else
          (R.Kind = Reload_By_Hand and then S.Mode = Started_With_Watchdog)
      then
         Finish (P, Done, Next);
      elsif (R.Kind = Drive and then S.Mode = Not_Started)
        or else (R.Kind = Stop and then S.Idle)
      then
         Finish (P, Refused, Next);
      elsif R.Kind in Close_Line | Reset | Power_Off
        and then S.Mode /= Not_Started
      then
         Begin_Exchange (S, P, Leaving, Wire.Stop, Next);
      else
         Act (S, P, Next);
      end if;
   end Start_Request;

   procedure Answered
     (S    : in out State;
      P    : in out Progress;
      Last : Step_Result;
      Next : out Step)
   is
      --  The exchange of the phase has been answered
      Accepted : constant Boolean := Is_Accepted (Last);
   begin
      case Exchange_Phase'(P.Phase) is
         when Clearing =>
            S.Idle := Accepted;
            Finish (P, Done, Next);

         when Leaving =>
            --  a robot that refuses a stop is not running
            Act (S, P, Next);

         when Asking_Motion =>
            if Accepted and then Last.Reply.Value /= 0 then
               P.Result.Note := Missed_Window;
               Finish (P, Refused, Next);
            else
               --  not moving: a stop changes nothing, and is accepted only by
               --  a running robot
               Begin_Exchange (S, P, Testing_Run, Wire.Stop, Next);
            end if;

         when Testing_Run =>
            if not Accepted then
               P.Result.Note := Not_Running;
               S.Mode := Not_Started;
            elsif P.Request.Kind = Reload then
               P.Result.Note := Missed_Window;
            end if;
            Finish
              (P,
               (if Accepted and then P.Request.Kind = Stop then Done
                else Refused),
               Next);

         when Acting =>
            if Accepted then
               P.Result.Text := Last.Text;
               case P.Request.Kind is
                  when Start =>
                     S.Mode := Started;
                  when Start_Watchdog =>
                     S.Mode := Started_With_Watchdog;
                  when Reset | Power_Off =>
                     S.Mode := Not_Started;
                     S.Idle := True;
                  when others =>
                     null;
               end case;
               Finish (P, Done, Next);
            elsif P.Request.Kind = Reload then
               Begin_Exchange
                 (S, P, Asking_Motion, (Wire.Busy, 0), Next);
            elsif P.Request.Kind in Drive | Stop
              and then S.Mode /= Not_Started
            then
               --  it may have been damaged on its way
               Begin_Exchange (S, P, Testing_Run, Wire.Stop, Next);
            else
               if P.Request.Kind = Reset then
                  --  refused only if the robot is not running
                  S.Mode := Not_Started;
               end if;
               Finish (P, Refused, Next);
            end if;
      end case;
   end Answered;

   procedure Unanswered
     (S    : in out State;
      P    : in out Progress;
      Next : out Step)
   is
      --  The exchange of the phase, or the probe before it, has failed
      Pending : constant Wire.Command_Kind :=
        (if P.In_Probe then Robot.Health.Probe (S.Health)
         else P.Wanted.Kind);
      Probed  : constant Boolean := P.In_Probe;
   begin
      S.Health := Robot.Health.After_Failure (S.Health, Pending);
      P.In_Probe := False;
      P.Result.Kind := Timed_Out;
      if Robot.Health.Lost (S.Health) then
         --  a last stop, in case the robot still receives
         P.Result.Note := Robot_Lost;
         P.Phase := Losing;
         P.Stopped := True;
         Next := (Send, Wire.Stop);
      elsif P.Phase = Leaving then
         if P.Tries < Leave_Tries then
            P.Tries := P.Tries + 1;
            Begin_Exchange (S, P, Leaving, Wire.Stop, Next);
         else
            Act (S, P, Next);
         end if;
      elsif P.Phase = Acting and then P.Request.Kind = Power_Off
        and then Probed = P.Off_Sent
      then
         if Probed then
            --  it is off
            S := (Line_Open => True,
                  Health    => Robot.Health.Opened,
                  others    => <>);
            Finish (P, Done, Next);
         else
            --  it may have switched off before it had answered
            P.Off_Sent := True;
            Begin_Exchange (S, P, Acting, Command_For (P.Request), Next);
         end if;
      elsif P.Phase = Clearing then
         --  the line stays open: the robot may be switched off
         Finish (P, Done, Next);
      else
         if P.Phase in Asking_Motion | Testing_Run
           and then P.Request.Kind = Reload
         then
            P.Result.Note := Missed_Window;
         end if;
         Finish (P, Timed_Out, Next);
      end if;
   end Unanswered;

   procedure Continue_Request
     (S      : in out State;
      P      : in out Progress;
      Last   : Step_Result;
      Next   : out Step)
   is
      Phase  : constant Phase_Kind   := P.Phase;
      Wanted : constant Wire.Command := P.Wanted;
   begin
      if P.Request.Kind in Start | Start_Watchdog then
         S.Idle := False;
      end if;
      case Phase is
         when Opening =>
            if Last.Ok then
               S := (Line_Open => True,
                     Health    => Robot.Health.Opened,
                     others    => <>);
               --  first a reset without awaiting its answer: it also resets a
               --  robot that receives but answers late
               P.Phase := Clearing;
               P.Wanted := (Wire.Reset, 0);
               Next := (Send, P.Wanted);
            else
               Finish (P, Not_Opened, Next);
            end if;

         when Closing =>
            S := (others => <>);
            Finish
              (P,
               (if P.Result.Note = Robot_Lost then Timed_Out else Done),
               Next);

         when Losing =>
            P.Phase := Closing;
            Next := (Close_Device, Wire.Stop);

         when Ended =>
            Next := (Finish, Wire.Stop);

         when Clearing | Leaving | Acting | Asking_Motion | Testing_Run =>
            if not P.In_Probe and then not Robot.Health.In_Step (S.Health) then
               --  the blind stop has been sent, or the reset of a newly opened
               --  line; now synchronise
               Begin_Exchange (S, P, Phase, Wanted, Next);
            elsif not Last.Ok then
               Unanswered (S, P, Next);
            elsif P.In_Probe then
               S.Health := Robot.Health.Initial;
               Begin_Exchange (S, P, Phase, Wanted, Next);
            else
               S.Health := Robot.Health.Initial;
               Answered (S, P, Last, Next);
            end if;
      end case;
   end Continue_Request;

end Robot.Session;
