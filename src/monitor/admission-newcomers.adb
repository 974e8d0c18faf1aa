--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time; use Ada.Real_Time;
with Journal;
with Monitor.Outbox;
with Monitor.Session;
with Monitor.Sockets.Connection;
with Options;
with Schedule;
with Trace;

package body Admission.Newcomers with SPARK_Mode is

   use type Monitor.Session.Stage_Kind;
   use type Monitor.Sockets.Socket;

   subtype Place_Choice is Natural range 0 .. Place'Last;  --  0: none

   function Oldest (G : Gate; State : Standing) return Place_Choice
   with
     Post => (if Oldest'Result > 0 then G.Places (Oldest'Result).State = State)
   is
      Found : Place_Choice := 0;
   begin
      for P in Place loop
         if G.Places (P).State = State
           and then (Found = 0
                     or else G.Places (P).Came < G.Places (Found).Came)
         then
            Found := P;
         end if;
         pragma Loop_Invariant
           (if Found > 0 then G.Places (Found).State = State);
      end loop;
      return Found;
   end Oldest;

   procedure Turn_Away (G : in out Gate; Where : Place; Why : String)
   with Pre => Why'Length < 100
   is
      --  Tells it why, and the log, where there is a line for that
   begin
      Monitor.Sockets.Gate.Refuse
        (G.Places (Where).Line, "MSSG:refused: " & Why & ASCII.LF);
      if G.Refused < Schedule.Refusals_Logged then
         Journal.Put
           (Options.Warning,
            "newcomer refused, " & Why & ": "
            & Texts.Image (G.Places (Where).Name));
      end if;
      G.Refused := Natural'Min (G.Refused, Natural'Last - 1) + 1;
      G.Places (Where) := (others => <>);
   end Turn_Away;

   procedure Settle (G : in out Gate) is
      --  Of those entitled the oldest is admitted where nobody is in command;
      --  the others are told why not, or wait while a session is being ended
      Where    : Place_Choice;
      Current  : Monitor.Session.Status;
      Admitted : Boolean;
   begin
      loop
         Where := Oldest (G, Entitled);
         exit when Where = 0;
         Monitor.Session.State.Get (Current);
         if Current.Stopping then
            Turn_Away (G, Where, "the supervisor is stopping");
         elsif Current.Stage = Monitor.Session.Active then
            Turn_Away (G, Where, "another monitor is connected");
         elsif Current.Stage = Monitor.Session.Free then
            Monitor.Session.State.Begin_Active (Admitted);
            if Admitted then
               pragma Assert (G.Places (Where).State = Entitled);
               Monitor.Sockets.Connection.Take_Over (G.Places (Where).Line);
               Monitor.Outbox.Open_Session;
               Journal.Put
                 (Options.Info,
                  "monitor connected from "
                  & Texts.Image (G.Places (Where).Name));
               G.Places (Where) := (others => <>);
               Monitor.Session.Receive_Begins.Set;
               Monitor.Session.Watch_Begins.Set;
            end if;
         else
            exit;
         end if;
      end loop;
   end Settle;

   procedure Hear (G : in out Gate; Where : Place)
   with Pre => G.Places (Where).State = Asked
   is
      --  It may have sent something, or has no more time
      N       : Newcomer := G.Places (Where);
      Now     : constant Time := Clock;
      Length  : Natural;
      Open    : Boolean;
      Verdict : Admission.Verdict;
   begin
      Monitor.Sockets.Gate.Read_Line
        (N.Line, N.Reader.Data (N.Reader.Length + 1 .. N.Reader.Data'Last),
         Length, Open);
      N.Reader.Length := N.Reader.Length + Length;
      Verdict := Decision (N.Reader, G.Token);
      if Verdict = Right then
         N.State := Entitled;
      end if;
      G.Places (Where) := N;
      if Verdict = Wrong
        or else (N.State = Asked
                 and then (not Open
                           or else Now - Schedule.Token_Limit >= N.Came))
      then
         Turn_Away (G, Where, "not authenticated");
      end if;
   end Hear;

   procedure Take_In (G : in out Gate; Where : Place; More : out Boolean)
   with Pre => G.Places (Where).State = Free
   is
      --  The next of the kernel's queue, which is asked for its token where
      --  there is one. More: there may be another
      N : Newcomer;
   begin
      Monitor.Sockets.Take_In (N.Line, N.From, N.Name);
      N.Came := Clock;
      G.Places (Where) := N;
      More := N.Line /= Monitor.Sockets.Nobody;
      if More and then not Networks.Admits (G.Allowed, N.From) then
         Turn_Away (G, Where, "this address is not allowed");
      elsif More and then G.Token.Length = 0 then
         G.Places (Where).State := Entitled;
      elsif More then
         G.Places (Where).State := Asked;
         Hear (G, Where);
      elsif N.Name.Length > 0 then
         Journal.Put
           (Options.Error,
            "a monitor could not connect: " & Texts.Image (N.Name));
         --  out of descriptors, most likely: not at full speed
         G.Rest := N.Came + Schedule.Accept_Pause;
      end if;
   end Take_In;

   procedure Count_Refusals (G : in out Gate) is
      --  Begins a new interval of them when the last is over
      Now  : constant Time := Clock;
      Line : Texts.Text;
   begin
      if Now >= G.Interval_End then
         if G.Refused > Schedule.Refusals_Logged then
            Texts.Set (Line, "newcomers refused, too many for the log: ");
            Texts.Append (Line, G.Refused - Schedule.Refusals_Logged);
            Journal.Put (Options.Warning, Line);
         end if;
         G.Refused := 0;
         G.Interval_End := Now + Schedule.Refusal_Interval;
      end if;
   end Count_Refusals;

   procedure Serve (G : in out Gate) is
      Watched : Monitor.Sockets.Gate.Socket_Array :=
        (others => Monitor.Sockets.Nobody);
      More    : Boolean := True;
      Left    : Natural := Schedule.Newcomers_Per_Turn;
      Where   : Place_Choice;
      Next    : Time;
   begin
      for P in Place loop
         if G.Places (P).State = Asked then
            Watched (P) := G.Places (P).Line;
         end if;
      end loop;
      delay until G.Rest;
      Monitor.Sockets.Gate.Wait
        (Watched,
         Oldest (G, Asked) > 0 or else G.Refused > Schedule.Refusals_Logged);
      Count_Refusals (G);
      for P in Place loop
         pragma Loop_Invariant (Left > Place'Last - P);
         if G.Places (P).State = Asked then
            Hear (G, P);
            Left := Left - 1;
         end if;
      end loop;
      while More and then Left > 0 loop
         Settle (G);
         Where := Oldest (G, Free);
         exit when Where = 0;
         Take_In (G, Where, More);
         Left := Left - 1;
         Where := Oldest (G, Asked);
         if Where > 0 and then Oldest (G, Free) = 0 then
            Turn_Away (G, Where, "not authenticated");
         end if;
      end loop;
      Settle (G);
      Next := Clock;
      Next := Next + Schedule.Newcomer_Interval;
      if G.Rest < Next then
         G.Rest := Next;
      end if;
      Trace.Put (Trace.Done, Schedule.Th_Server);
   end Serve;

end Admission.Newcomers;
