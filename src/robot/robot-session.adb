--  SPDX-License-Identifier: GPL-3.0-or-later

package body Robot.Session with SPARK_Mode is

   Just_Opened : constant State :=
     (Line_Open => True, Health => Health.Opened, others => <>);

   procedure Begin_Exchange
     (S       : State;
      P       : in out Progress;
      Phase   : Phase_Kind;
      Command : Protocol.Command)
   is
      --  Exchanges Command in Phase. If the line is out of step, a probe comes
      --  first, and before the probe a blind stop
      In_Step : constant Boolean := Health.In_Step (S.Health);
      Is_Stop : constant Boolean := Command = Protocol.Stop;
   begin
      P.Phase    := Phase;
      P.Wanted   := Command;
      P.In_Probe := not In_Step and then (P.Blind or else not Is_Stop);
      P.Blind    := P.Blind or else (Is_Stop and then not In_Step);
      P.Stopped  := P.Stopped or else Is_Stop;
   end Begin_Exchange;

   procedure Finish (P : in out Progress; Kind : Outcome_Kind) is
   begin
      P.Phase := Ended;
      P.Result.Kind := Kind;
   end Finish;

   procedure Act (S : State; P : in out Progress) is
      --  The command of the request, after the stop if one was due
   begin
      case P.Request.Kind is
         when Open_Line =>
            P.Phase := Opening;
         when Close_Line =>
            P.Phase := Closing;
         when others =>
            Begin_Exchange (S, P, Acting, Command_For (P.Request));
      end case;
   end Act;

   procedure Start_Request (S : State; R : Request; P : out Progress) is
   begin
      P := (Request => R, others => <>);
      if not S.Line_Open and then R.Kind not in Open_Line | Close_Line then
         Finish (P, Not_Open);
      elsif (R.Kind = Open_Line and then S.Line_Open)
        or else (R.Kind = Close_Line and then not S.Line_Open)
        or else (R.Kind = Reload and then S.Mode /= Started_With_Watchdog)
        or else
          (R.Kind = Reload_By_Hand and then S.Mode = Started_With_Watchdog)
      then
         Finish (P, Done);
      elsif (R.Kind = Drive and then S.Mode = Not_Started)
        or else (R.Kind = Stop and then S.Idle)
      then
         Finish (P, Refused);
      elsif R.Kind in Close_Line | Reset | Power_Off
        and then S.Mode /= Not_Started
      then
         Begin_Exchange (S, P, Leaving, Protocol.Stop);
      else
         Act (S, P);
      end if;
   end Start_Request;

   procedure Answered
     (S : in out State; P : in out Progress; Last : Step_Result)
   is
      --  The exchange of the phase has been answered
      Accepted : constant Boolean := Is_Accepted (Last);
   begin
      case Exchange_Phase'(P.Phase) is
         when Clearing =>
            S.Idle := Accepted;
            Finish (P, Done);

         when Leaving =>
            --  a robot that refuses a stop is not running
            Act (S, P);

         when Asking_Motion =>
            if Accepted and then Last.Reply.Value /= 0 then
               P.Result.Note := Missed_Window;
               Finish (P, Refused);
            else
               --  not moving: a stop changes nothing, and is accepted only by
               --  a running robot
               Begin_Exchange (S, P, Testing_Run, Protocol.Stop);
            end if;

         when Testing_Run =>
            if not Accepted then
               P.Result.Note := Not_Running;
               S.Mode := Not_Started;
            elsif P.Request.Kind = Reload then
               P.Result.Note := Missed_Window;
            end if;
            Finish
              (P, (if Accepted and then P.Request.Kind = Stop then Done
                   else Refused));

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
               Finish (P, Done);
            elsif P.Request.Kind = Reload then
               Begin_Exchange (S, P, Asking_Motion, (Protocol.Busy, 0));
            elsif P.Request.Kind in Drive | Stop
              and then S.Mode /= Not_Started
            then
               --  it may have been damaged on its way
               Begin_Exchange (S, P, Testing_Run, Protocol.Stop);
            else
               if P.Request.Kind = Reset then
                  --  refused only if the robot is not running
                  S.Mode := Not_Started;
               end if;
               Finish (P, Refused);
            end if;
      end case;
   end Answered;

   procedure Unanswered (S : in out State; P : in out Progress) is
      --  The exchange of the phase, or the probe before it, has failed
   begin
      S.Health :=
        Health.After_Failure (S.Health, Next_Step (S, P).Command.Kind);
      if Health.Lost (S.Health) then
         --  a last stop, in case the robot still receives
         P.Result.Note := Robot_Lost;
         P.Phase := Losing;
         P.Stopped := True;
      elsif P.Phase = Leaving then
         if P.Tries < Leave_Tries then
            P.Tries := P.Tries + 1;
            Begin_Exchange (S, P, Leaving, Protocol.Stop);
         else
            Act (S, P);
         end if;
      elsif P.Phase = Acting and then P.Request.Kind = Power_Off
        and then P.In_Probe = P.Off_Sent
      then
         if P.In_Probe then
            --  it is off
            S := Just_Opened;
            Finish (P, Done);
         else
            --  it may have switched off before it had answered
            P.Off_Sent := True;
            Begin_Exchange (S, P, Acting, Command_For (P.Request));
         end if;
      elsif P.Phase = Clearing then
         --  the line stays open: the robot may be switched off
         Finish (P, Done);
      else
         if P.Phase in Asking_Motion | Testing_Run
           and then P.Request.Kind = Reload
         then
            P.Result.Note := Missed_Window;
         end if;
         Finish (P, Timed_Out);
      end if;
   end Unanswered;

   procedure Continue_Request
     (S : in out State; P : in out Progress; Last : Step_Result) is
   begin
      if P.Request.Kind in Start | Start_Watchdog then
         S.Idle := False;
      end if;
      case P.Phase is
         when Opening =>
            if Last.Ok then
               S := Just_Opened;
               --  first a reset without awaiting its answer: it also resets a
               --  robot that receives but answers late
               P.Phase := Clearing;
               P.Wanted := (Protocol.Reset, 0);
            else
               Finish (P, Not_Opened);
            end if;

         when Closing =>
            S := (others => <>);
            Finish
              (P, (if P.Result.Note = Robot_Lost then Timed_Out else Done));

         when Losing =>
            P.Phase := Closing;

         when Ended =>
            null;

         when Exchange_Phase =>
            if not P.In_Probe and then not Health.In_Step (S.Health) then
               --  the blind stop has been sent, or the reset of a newly opened
               --  line
               P.In_Probe := True;
            elsif not Last.Ok then
               Unanswered (S, P);
            else
               S.Health := Health.Initial;
               if P.In_Probe then
                  P.In_Probe := False;
               else
                  Answered (S, P, Last);
               end if;
            end if;
      end case;
   end Continue_Request;

end Robot.Session;
