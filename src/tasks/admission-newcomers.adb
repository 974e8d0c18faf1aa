--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time; use Ada.Real_Time;
with Journal;
with Monitor.Outbox;
with Monitor.Session;
with Monitor.Session_Stages;
with Monitor.Sockets.Connection;
with Options;
with Trace;

package body Admission.Newcomers with SPARK_Mode is

   use type Admission.Authentication.Verdict;
   use type Monitor.Session_Stages.Stage_Kind;
   use type Monitor.Sockets.Socket;

   subtype Place_Choice is Natural range 0 .. Place'Last;
   --  0: none

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
   with
     Pre  => Is_Consistent (G) and then Why'Length < 100,
     Post => Is_Consistent (G)
   is
      --  Tells it why, and the log, where there is a line for that
   begin
      Monitor.Sockets.Gate.Refuse
        (G.Places (Where).Line, "MSSG:refused: " & Why & ASCII.LF);
      if G.Lines > 0 then
         G.Lines := G.Lines - 1;
         Journal.Put
           (Options.Warning,
            "newcomer refused, " & Why & ": "
            & Texts.Image (G.Places (Where).Name));
      elsif G.Unlogged < Natural'Last then
         G.Unlogged := G.Unlogged + 1;
      end if;
      G.Places (Where) := (others => <>);
   end Turn_Away;

   procedure Let_In (G : in out Gate; Where : Place)
   with
     Pre  => Is_Consistent (G) and then G.Places (Where).State = Entitled,
     Post => Is_Consistent (G)
   is
      --  It is in command now
   begin
      Monitor.Sockets.Connection.Take_Over (G.Places (Where).Line);
      Monitor.Outbox.Open_Session;
      Journal.Put
        (Options.Info,
         "monitor connected from " & Texts.Image (G.Places (Where).Name));
      G.Places (Where) := (others => <>);
      Monitor.Session.Receive_Begins.Set;
      Monitor.Session.Watch_Begins.Set;
   end Let_In;

   procedure Settle (G : in out Gate)
   with
     Pre  => Is_Consistent (G),
     Post => Is_Consistent (G)
   is
      --  Of those entitled the oldest is admitted where nobody is in command;
      --  the others are told why not, or wait while a session is being ended
      Where    : Place_Choice;
      Current  : Monitor.Session_Stages.State;
      Admitted : Boolean;
   begin
      loop
         pragma Loop_Invariant (Is_Consistent (G));
         Where := Oldest (G, Entitled);
         exit when Where = 0;
         Monitor.Session.State.Get (Current);
         if Current.Stopping then
            Turn_Away (G, Where, "the supervisor is stopping");
         elsif Current.Stage = Monitor.Session_Stages.Active then
            Turn_Away (G, Where, "another monitor is connected");
         elsif Current.Stage = Monitor.Session_Stages.Free then
            Monitor.Session.State.Begin_Active (Admitted);
            if Admitted then
               Let_In (G, Where);
            end if;
         else
            exit;
         end if;
      end loop;
   end Settle;

   procedure Hear (G : in out Gate; Where : Place)
   with
     Pre  => Is_Consistent (G) and then G.Places (Where).State = Asked,
     Post => Is_Consistent (G)
   is
      --  It may have sent something, or has no more time
      N       : Newcomer := G.Places (Where);
      Now     : constant Time := Clock;
      Length  : Natural;
      Open    : Boolean;
      Verdict : Admission.Authentication.Verdict;
   begin
      Monitor.Sockets.Gate.Read_Line
        (N.Line, N.Reader.Data (N.Reader.Length + 1 .. N.Reader.Data'Last),
         Length, Open);
      N.Reader.Length := N.Reader.Length + Length;
      Verdict := Admission.Authentication.Decision (N.Reader, G.Token);
      if Verdict = Admission.Authentication.Right then
         N.State := Entitled;
      end if;
      G.Places (Where) := N;
      if Verdict = Admission.Authentication.Wrong
        or else (N.State = Asked
                 and then (not Open
                           or else Now - Schedule.Token_Limit >= N.Came))
      then
         Turn_Away (G, Where, "not authenticated");
      end if;
   end Hear;

   procedure Meet (G : in out Gate; N : Newcomer)
   with
     Pre  => Is_Consistent (G) and then N.State = Free,
     Post => Is_Consistent (G)
   is
      --  Asks for its token where there is one. Where there are too many now,
      --  the one that has waited longest is turned away
      Where : Place_Choice := Oldest (G, Free);
   begin
      if Where > 0 then
         G.Places (Where) := N;
         if not Admission.Networks.Admits (G.Allowed, N.From) then
            Turn_Away (G, Where, "this address is not allowed");
         elsif G.Token.Length = 0 then
            G.Places (Where).State := Entitled;
         else
            G.Places (Where).State := Asked;
            Hear (G, Where);
         end if;
         Settle (G);
      end if;
      Where := Oldest (G, Asked);
      if Where > 0 and then Oldest (G, Free) = 0 then
         Turn_Away (G, Where, "not authenticated");
      end if;
   end Meet;

   procedure Take_In (G : in out Gate; More : out Boolean)
   with
     Pre  => Is_Consistent (G),
     Post => Is_Consistent (G)
   is
      --  The next of the kernel's queue. More: there may be another
      N : Newcomer;
   begin
      Monitor.Sockets.Gate.Take_In (N.Line, N.From, N.Name);
      N.Came := Clock;
      More := N.Line /= Monitor.Sockets.Nobody;
      if More then
         Meet (G, N);
      elsif N.Name.Length > 0 then
         Journal.Put
           (Options.Error,
            "a monitor could not connect: " & Texts.Image (N.Name));
         --  out of descriptors, most likely: not at full speed
         G.Rest := N.Came + Schedule.Accept_Pause;
      end if;
   end Take_In;

   procedure Close_Session is
      --  One that has been brought back
      Current : Monitor.Session_Stages.State;
   begin
      Monitor.Session.State.Get (Current);
      if Current.Stage = Monitor.Session_Stages.Closed then
         Monitor.Sockets.Connection.Close;
         Monitor.Session.State.Go_On (Monitor.Session_Stages.Free);
         Journal.Put
           (Options.Info, "session closed, ready for a new monitor");
      end if;
   end Close_Session;

   procedure Count_Refusals (G : in out Gate) is
      --  Begins a new interval of them when the last is over
      Now  : constant Time := Clock;
      Line : Texts.Text;
   begin
      if Now >= G.Lines_End then
         if G.Unlogged > 0 then
            Texts.Set (Line, "newcomers refused, too many for the log: ");
            Texts.Append (Line, G.Unlogged);
            Journal.Put (Options.Warning, Line);
         end if;
         G.Unlogged := 0;
         G.Lines := Schedule.Refusals_Logged;
         G.Lines_End := Now + Schedule.Refusal_Interval;
      end if;
   end Count_Refusals;

   procedure Serve (G : in out Gate) is
      Watched : Monitor.Sockets.Gate.Socket_Array :=
        (others => Monitor.Sockets.Nobody);
      More    : Boolean := True;
      Left    : Natural := Schedule.Newcomers_Per_Turn;
      Next    : Time;
   begin
      for P in Place loop
         if G.Places (P).State = Asked then
            Watched (P) := G.Places (P).Line;
         end if;
      end loop;
      delay until G.Rest;
      Monitor.Sockets.Gate.Wait
        (Watched, Oldest (G, Asked) > 0 or else G.Unlogged > 0);
      Trace.Take_Up (Schedule.Th_Server);
      Count_Refusals (G);
      Close_Session;
      for P in Place loop
         pragma Loop_Invariant
           (Is_Consistent (G) and then Left > Place'Last - P);
         if G.Places (P).State = Asked then
            Hear (G, P);
            Left := Left - 1;
         end if;
      end loop;
      Settle (G);
      while More and then Left > 0 loop
         pragma Loop_Invariant (Is_Consistent (G));
         Take_In (G, More);
         Left := Left - 1;
      end loop;
      Next := Clock;
      Next := Next + Schedule.Newcomer_Interval;
      if G.Rest < Next then
         G.Rest := Next;
      end if;
      Trace.Done (Schedule.Th_Server);
   end Serve;

end Admission.Newcomers;
