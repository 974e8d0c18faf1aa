--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time; use Ada.Real_Time;
with Event_Counters;
with Interfaces;
with Interfaces.C;
with Journal;
with Monitor.Outbox;
with Monitor.Session;
with Monitor.Sockets.Connection;
with Options;
with Schedule;
with Trace;

package body Admission.Newcomers with SPARK_Mode is

   use type Interfaces.C.int;
   use type Interfaces.Unsigned_16;
   use type Monitor.Session.Stage_Kind;
   use type Monitor.Sockets.Socket;

   Waker : constant Event_Counters.Counter := Event_Counters.New_Counter;
   --  Of Wake_Server

   Coming : constant Positive := Place'Last + 1;
   Waking : constant Positive := Place'Last + 2;
   --  Indices of the other descriptors that th_server waits for

   Look_Now      : constant := 16#42#;    --  MSG_PEEK, MSG_DONTWAIT
   Receive_Now   : constant := 16#40#;    --  MSG_DONTWAIT
   Send_With_End : constant := 16#C040#;
   --  MSG_NOSIGNAL, MSG_DONTWAIT, MSG_MORE
   Sending       : constant := 1;         --  SHUT_WR

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
      --  Tells it why, and the log, where there is a line for that. Never
      --  waits
      Refused      : constant Monitor.Sockets.Socket := G.Places (Where).Line;
      Ignored_Data : String (1 .. 256) := (others => ' ');
      Ignored      : Monitor.Sockets.Outcome;
   begin
      --  message and FIN in one packet, which takes half the time: there may
      --  be a flood of rejections
      Monitor.Sockets.Send
        (Refused, Send_With_End, "MSSG:refused: " & Why & ASCII.LF, Ignored);
      Monitor.Sockets.Shut_Down (Refused, Sending);
      --  unread data would turn the close into a reset, which could overtake
      --  the message
      Monitor.Sockets.Receive (Refused, Receive_Now, Ignored_Data, Ignored);
      Monitor.Sockets.Close (Refused);
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

   procedure Read_Line
     (From   : Monitor.Sockets.Socket;
      Data   : in out String;
      Length : out Natural;
      Open   : out Boolean)
   with
     Pre  => Data'First > 0,
     Post => Length <= Data'Length
   is
      --  What the peer has sent, up to the first line feed: what follows is
      --  left for the session. Never waits. Not Open: the peer has closed
      Got : Monitor.Sockets.Outcome;
   begin
      Monitor.Sockets.Receive (From, Look_Now, Data, Got);
      Open := Got > 0
        or else Got in Monitor.Sockets.Try_Again | Monitor.Sockets.Interrupted;
      Length := Integer'Max (0, Got);
      for I in 1 .. Length loop
         pragma Loop_Invariant (Length = Got);
         if Data (Data'First + (I - 1)) = ASCII.LF then
            Length := I;
            exit;
         end if;
      end loop;
      if Length > 0 then
         Monitor.Sockets.Receive
           (From, Receive_Now, Data (Data'First .. Data'First + (Length - 1)),
            Got);
         Length := Integer'Max (0, Got);
      end if;
   end Read_Line;

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
      Read_Line
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
            Journal.Put (Options.Warning, Texts.Image (Line));
         end if;
         G.Refused := 0;
         G.Interval_End := Now + Schedule.Refusal_Interval;
      end if;
   end Count_Refusals;

   procedure Wait (G : Gate) is
      --  For input from one of those asked, or its end, for a connection in
      --  the kernel's queue, or for Wake_Server. May return early
      Entries : Monitor.Sockets.Watch_Array (1 .. Waking);
      Server  : constant Monitor.Sockets.Socket := Monitor.Sockets.Listening;
      Ignored : Natural;
   begin
      for P in Place loop
         if G.Places (P).State = Asked then
            Entries (P).Descriptor := Interfaces.C.int (G.Places (P).Line);
         end if;
      end loop;
      Entries (Coming).Descriptor := Interfaces.C.int (Server);
      Entries (Waking).Descriptor := Interfaces.C.int (Waker);
      Monitor.Sockets.Poll
        (Entries,
         (if Oldest (G, Asked) > 0
            or else G.Refused > Schedule.Refusals_Logged
          then Interfaces.C.int (Schedule.Pending_Period / Milliseconds (1))
          else -1));
      Trace.Put (Trace.Start, Schedule.Th_Server);
      if Entries (Waking).Returned /= 0 then
         Event_Counters.Take (Waker, Ignored);
      end if;
   end Wait;

   procedure Serve (G : in out Gate) is
      More  : Boolean := True;
      Left  : Natural := Schedule.Newcomers_Per_Turn;
      Where : Place_Choice;
      Next  : Time;
   begin
      delay until G.Rest;
      Wait (G);
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

   procedure Wake_Server is
   begin
      Event_Counters.Add (Waker);
   end Wake_Server;

end Admission.Newcomers;
