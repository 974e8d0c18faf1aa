--  SPDX-License-Identifier: GPL-3.0-or-later
--  The session with the robot: what each request means in each state, as a
--  sequence of steps on the line. Decides; the owner of the line carries out.

package body Robot_Session with SPARK_Mode is

   package Wire renames Robot_Protocol;

   Leave_Tries : constant := 3;
   --  How often the stop on the way out is tried while the line still works

   procedure Begin_Exchange
     (S       : State;
      P       : in out Progress;
      Phase   : Phase_Kind;
      Command : Wire.Command;
      Next    : out Step);
   --  The step that exchanges Command in Phase: a probe comes first where
   --  the line is out of step, and before the probe, blindly, a stop

   procedure Finish
     (P    : in out Progress;
      Kind : Outcome_Kind;
      Next : out Step);

   procedure Act
     (S    : State;
      P    : in out Progress;
      Next : out Step);
   --  The command that the request is for, after the stop where one was due

   procedure Answered
     (S     : in out State;
      P     : in out Progress;
      Reply : Wire.Reply;
      Next  : out Step);
   --  The exchange of the phase has its answer

   procedure Unanswered
     (S    : in out State;
      P    : in out Progress;
      Next : out Step);
   --  The exchange of the phase, or the probe before it, failed

   --------------------
   -- Begin_Exchange --
   --------------------

   procedure Begin_Exchange
     (S       : State;
      P       : in out Progress;
      Phase   : Phase_Kind;
      Command : Wire.Command;
      Next    : out Step)
   is
   begin
      P.Phase  := Phase;
      P.Wanted := Command;
      P.In_Probe := False;
      if Line_Health.In_Step (S.Health) then
         Next := (Exchange, Command);
      elsif Command = Wire.Stop and then not P.Blind then
         P.Blind := True;
         Next := (Send, Command);
      else
         P.In_Probe := True;
         P.Probing  := Line_Health.Probe (S.Health);
         Next := (Synchronise, (Kind => P.Probing, Value => 0));
      end if;
   end Begin_Exchange;

   ------------
   -- Finish --
   ------------

   procedure Finish
     (P    : in out Progress;
      Kind : Outcome_Kind;
      Next : out Step)
   is
   begin
      P.Phase := Ended;
      P.Result.Kind := Kind;
      Next := (Finish, Wire.Stop);
   end Finish;

   ---------
   -- Act --
   ---------

   procedure Act
     (S    : State;
      P    : in out Progress;
      Next : out Step)
   is
      function Simple (Kind : Wire.Command_Kind) return Wire.Command is
        (Kind => Kind, Value => 0);
      Wanted : Wire.Command;
   begin
      case P.Request.Kind is
         when Open_Line =>
            P.Phase := Opening;
            Next := (Open_Device, Wire.Stop);
         when Close_Line =>
            P.Phase := Closing;
            Next := (Close_Device, Wire.Stop);
         when Start =>
            Begin_Exchange (S, P, Acting, Simple (Wire.Start), Next);
         when Start_Watchdog =>
            Begin_Exchange (S, P, Acting, Simple (Wire.Start_Watchdog), Next);
         when Reset =>
            Begin_Exchange (S, P, Acting, Simple (Wire.Reset), Next);
         when Ping | Keep_Alive =>
            Begin_Exchange (S, P, Acting, Simple (Wire.Ping), Next);
         when Power_Off =>
            Begin_Exchange (S, P, Acting, Simple (Wire.Power_Off), Next);
         when Get_Battery =>
            Begin_Exchange (S, P, Acting, Simple (Wire.Battery), Next);
         when Get_Moving =>
            Begin_Exchange (S, P, Acting, Simple (Wire.Busy), Next);
         when Drive =>
            Wanted := P.Request.Command;
            Begin_Exchange (S, P, Acting, Wanted, Next);
         when Stop =>
            Begin_Exchange (S, P, Acting, Wire.Stop, Next);
         when Reload | Reload_By_Hand =>
            Begin_Exchange (S, P, Acting, Simple (Wire.Reload), Next);
      end case;
   end Act;

   -------------------
   -- Start_Request --
   -------------------

   procedure Start_Request
     (S    : State;
      R    : Request;
      P    : out Progress;
      Next : out Step)
   is
   begin
      P := (Request => R, others => <>);
      if R.Kind = Open_Line then
         if S.Line_Open then
            Finish (P, Done, Next);
         else
            Act (S, P, Next);
         end if;
      elsif not S.Line_Open then
         if R.Kind = Close_Line then
            Finish (P, Done, Next);
         else
            Finish (P, Not_Open, Next);
         end if;
      elsif R.Kind = Drive and then S.Mode = Not_Started then
         Finish (P, Refused, Next);
      elsif (R.Kind = Reload and then S.Mode /= Started_With_Watchdog)
        or else
          (R.Kind = Reload_By_Hand and then S.Mode = Started_With_Watchdog)
        or else (R.Kind = Keep_Alive and then S.Mode = Not_Started)
      then
         Finish (P, Done, Next);
      elsif R.Kind in Close_Line | Reset | Power_Off
        and then S.Mode /= Not_Started
      then
         Begin_Exchange (S, P, Leaving, Wire.Stop, Next);
      else
         Act (S, P, Next);
      end if;
   end Start_Request;

   --------------
   -- Answered --
   --------------

   procedure Answered
     (S     : in out State;
      P     : in out Progress;
      Reply : Wire.Reply;
      Next  : out Step)
   is
      use type Wire.Reply_Kind;
      Accepted : constant Boolean :=
        Reply.Kind in Wire.Done | Wire.Level | Wire.Moving_State;
   begin
      case P.Phase is
         when Clearing =>
            Finish (P, Done, Next);

         when Leaving =>
            --  a robot that refuses a stop is not running
            Act (S, P, Next);

         when Asking_Motion =>
            if Accepted and then Reply.Value /= 0 then
               P.Result.Note := Missed_Window;
               Finish (P, Refused, Next);
            else
               --  standing still: a stop changes nothing, and only a
               --  running robot accepts it
               Begin_Exchange (S, P, Testing_Run, Wire.Stop, Next);
            end if;

         when Testing_Run =>
            if Accepted then
               P.Result.Note := Missed_Window;
            else
               P.Result.Note := Not_Running;
               S.Mode := Not_Started;
            end if;
            Finish (P, Refused, Next);

         when Acting =>
            if Accepted then
               P.Result.Value := Reply.Value;
               case P.Request.Kind is
                  when Start =>
                     S.Mode := Started;
                  when Start_Watchdog =>
                     S.Mode := Started_With_Watchdog;
                  when Reset | Power_Off =>
                     S.Mode := Not_Started;
                  when others =>
                     null;
               end case;
               Finish (P, Done, Next);
            elsif P.Request.Kind = Reload then
               Begin_Exchange
                 (S, P, Asking_Motion, (Wire.Busy, 0), Next);
            else
               if P.Request.Kind = Reset then
                  --  refused only where the robot does not run
                  S.Mode := Not_Started;
               end if;
               Finish (P, Refused, Next);
            end if;

         when Opening | Closing | Losing | Ended =>
            Finish (P, Done, Next);
      end case;
   end Answered;

   ----------------
   -- Unanswered --
   ----------------

   procedure Unanswered
     (S    : in out State;
      P    : in out Progress;
      Next : out Step)
   is
      Pending : constant Wire.Command_Kind :=
        (if P.In_Probe then P.Probing else P.Wanted.Kind);
   begin
      Line_Health.Failure (S.Health, Pending);
      P.In_Probe := False;
      P.Result.Kind := Timed_Out;
      if Line_Health.Lost (S.Health) then
         --  a last stop, in case the robot still hears
         P.Result.Note := Robot_Lost;
         P.Phase := Losing;
         Next := (Send, Wire.Stop);
      elsif P.Phase = Leaving then
         if P.Tries < Leave_Tries then
            P.Tries := P.Tries + 1;
            Begin_Exchange (S, P, Leaving, Wire.Stop, Next);
         else
            Act (S, P, Next);
         end if;
      elsif P.Phase = Clearing then
         --  the line is open all the same: its robot may be off
         Finish (P, Done, Next);
      elsif P.Phase in Asking_Motion | Testing_Run then
         P.Result.Note := Missed_Window;
         Finish (P, Timed_Out, Next);
      else
         Finish (P, Timed_Out, Next);
      end if;
   end Unanswered;

   ----------------------
   -- Continue_Request --
   ----------------------

   procedure Continue_Request
     (S      : in out State;
      P      : in out Progress;
      Last   : Step_Result;
      Next   : out Step)
   is
      Phase  : constant Phase_Kind   := P.Phase;
      Wanted : constant Wire.Command := P.Wanted;
   begin
      case Phase is
         when Opening =>
            if Last.Ok then
               S := (Line_Open => True,
                     Mode      => Not_Started,
                     Health    => Line_Health.Initial);
               Begin_Exchange (S, P, Clearing, (Wire.Reset, 0), Next);
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
            if P.Blind and then not P.In_Probe
              and then not Line_Health.In_Step (S.Health)
              and then P.Wanted = Wire.Stop
            then
               --  the blind stop is out; now get into step
               Begin_Exchange (S, P, Phase, Wanted, Next);
            elsif not Last.Ok then
               Unanswered (S, P, Next);
            elsif P.In_Probe then
               Line_Health.Success (S.Health);
               Begin_Exchange (S, P, Phase, Wanted, Next);
            else
               Line_Health.Success (S.Health);
               Answered (S, P, Last.Reply, Next);
            end if;
      end case;
   end Continue_Request;

end Robot_Session;
