--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time; use Ada.Real_Time;
with Admission.Secret_Files;
with Bytes;
with Journal;
with Monitor.Outbox;
with Monitor.Session;
with Monitor.Session_Stages;
with Monitor.Sockets.Connection;
with Monitor.Sockets.Gate;
with Options;
with Trace;

package body Admission.Newcomers with SPARK_Mode is

   use Admission.Pending_Connections;
   use type Bytes.Byte_Array;
   use type Monitor.Session_Stages.Stage_Kind;

   Not_Authenticated : constant String := "not authenticated";

   Noted_Not_Authenticated : constant String :=
     "newcomer refused, not authenticated: ";

   type Reception is
     (Vacant,      --  nobody is in command: the next one is admitted
      Occupied,    --  somebody is, and all others are refused
      Stopping,    --  the supervisor is: all are refused
      Deferred);   --  the end of a session is dealt with: they are to wait

   procedure Get_Reception (R : out Reception);

   procedure Get_Next
     (G       : Gate;
      Watched : out Place_Set;
      Listens : out Boolean;
      Limit   : out Time);
   --  What is to be waited for, and how long

   procedure Read
     (G      : in out Gate;
      Where  : Place;
      Length : out Natural;
      Open   : out Boolean)
   with
     Pre  => Is_Consistent (G) and then Is_Waiting (G.Table, Where),
     Post => Is_Consistent (G) and then Is_Waiting (G.Table, Where);
   --  What a newcomer has sent, up to the end of its first line: so many
   --  characters

   procedure Refuse
     (L       : in out Refusal_Log;
      Where   : Place;
      Message : String;
      Noted   : String)
   with Pre => Message'Length < 100;
   --  Tells who has come at this place Message, and Noted and its address to
   --  the log, where it has a line for that

   procedure Turn_Away
     (G       : in out Gate;
      Where   : Place;
      Message : String;
      Noted   : String)
   with
     Pre  => Is_Consistent (G)
       and then Is_Taken (G.Table, Where)
       and then Message'Length < 100,
     Post => Is_Consistent (G) and then not Is_Taken (G.Table, Where);
   --  The same, and its place is free

   procedure Let_In (G : in out Gate; Where : Place)
   with
     Pre  => Is_Consistent (G)
       and then Is_Kept (G.Table, Where)
       and then Is_Entitled (G, G.Places (Where)),
     Post => Is_Consistent (G) and then not Is_Taken (G.Table, Where);
   --  It is in command now

   procedure Decide (G : in out Gate; Where : Place; R : in out Reception)
   with
     Pre  => Is_Consistent (G) and then Is_Kept (G.Table, Where),
     Post => Is_Consistent (G);
   --  Admits it where nobody is in command, or tells it why not, or lets it
   --  wait

   procedure Hear (G : in out Gate; Where : Place; R : in out Reception)
   with
     Pre  => Is_Consistent (G) and then Is_Waiting (G.Table, Where),
     Post => Is_Consistent (G);
   --  A newcomer that may have sent something, or has no more time

   procedure Meet
     (G     : in out Gate;
      Where : Place;
      From  : Admission.Networks.Peer_Address;
      R     : in out Reception)
   with
     Pre  => Is_Consistent (G) and then not Is_Taken (G.Table, Where),
     Post => Is_Consistent (G);
   --  A newcomer: asks for its token where there is one. Where there are too
   --  many now, one of them is turned away

   subtype Work_Count is Natural range 0 .. Schedule.Newcomers_Per_Turn;

   procedure Hear_Some
     (G     : in out Gate;
      Ready : Place_Set;
      R     : in out Reception;
      Left  : in out Work_Count)
   with
     Pre  => Is_Consistent (G),
     Post => Is_Consistent (G);
   --  Those that have been kept, and of those that wait the Ready ones and
   --  those whose time is over, each source in turn. Left: of the turn's work

   procedure Take_In_Some
     (G : in out Gate; First : Reception; Most : Work_Count)
   with
     Pre  => Is_Consistent (G),
     Post => Is_Consistent (G);
   --  Newcomers from the kernel's queue, so many at most. First: how the first
   --  of them is received

   procedure Defend (D : in out Defence; Changed : out Boolean);
   --  Blocks the sources that fill the kernel's queue, for a while

   procedure Put_Unwritten (L : in out Refusal_Log);
   --  The log learns of refusals that it has no lines of

   procedure Close_Session;
   --  If it has been brought back: ready for the next monitor

   procedure Close_Session is
      Current : Monitor.Session_Stages.State;
   begin
      Monitor.Session.Get (Current);
      if Current.Stage = Monitor.Session_Stages.Closed then
         Monitor.Sockets.Connection.Close;
         Monitor.Session.End_Closed;
         Journal.Put
           (Options.Info, "session closed, ready for a new monitor");
      end if;
   end Close_Session;

   procedure Decide (G : in out Gate; Where : Place; R : in out Reception) is
      Admitted : Boolean;
   begin
      if R = Vacant then
         Monitor.Session.Begin_Active (Admitted);
         R := (if Admitted then Occupied else Stopping);
         if Admitted then
            Let_In (G, Where);
            return;
         end if;
      end if;
      case R is
         when Vacant | Deferred =>
            null;
         when Occupied =>
            Turn_Away
              (G, Where, "another monitor is connected",
               "second monitor refused: ");
         when Stopping =>
            Turn_Away
              (G, Where, "the supervisor is stopping",
               "monitor refused, the supervisor is stopping: ");
      end case;
   end Decide;

   procedure Defend (D : in out Defence; Changed : out Boolean) is
      Now    : constant Time := Clock;
      Length : Natural;
      Limit  : Natural;
      Done   : Boolean;
   begin
      Changed := D.Blocked.Count > 0 and then Now >= D.Release;
      if Changed then
         Admission.Blocklists.Remove_Oldest (D.Blocked);
         D.Release := Now + Schedule.Release_Interval;
      else
         Monitor.Sockets.Gate.Get_Queue (Length, Limit);
         --  a quarter: more come before th_server looks again
         if Length > Limit / 4 then
            Admission.Blocklists.Extend (D.Blocked, D.Arrivals, Changed);
         end if;
         if Changed then
            D.Release := Now + Schedule.Block_Time;
         end if;
      end if;
      if Changed then
         Monitor.Sockets.Gate.Block (D.Blocked, Done);
         if not Done and then not D.Unfiltered then
            D.Unfiltered := True;
            Journal.Put
              (Options.Warning,
               "a flood of connections, and this kernel gives no filter "
               & "against it (CAP_NET_ADMIN)");
         end if;
      end if;
   end Defend;

   procedure Get_Next
     (G       : Gate;
      Watched : out Place_Set;
      Listens : out Boolean;
      Limit   : out Time)
   is
      Now : constant Time := Clock;
      R   : Reception;

      procedure End_By (T : Time);

      procedure End_By (T : Time) is
      begin
         if T < Limit then
            Limit := T;
         end if;
      end End_By;

   begin
      Watched := (others => False);
      Limit := Time_Last;
      for I in Place loop
         if Is_Waiting (G.Table, I) then
            Watched (I) := True;
            End_By (G.Places (I).Limit);
         end if;
      end loop;
      Listens := Now >= G.Pause;
      if not Listens then
         End_By (G.Pause);
      end if;
      if G.Floods.Blocked.Count > 0 then
         End_By (G.Floods.Release);
      end if;
      if G.Refusals.Unwritten > 0 then
         End_By (G.Refusals.Last + Schedule.Refusal_Pause);
      end if;
      --  who has been kept until the end of a session
      if First_Kept (G.Table) in Place then
         Get_Reception (R);
         if R /= Deferred then
            Limit := Now;
         end if;
      end if;
   end Get_Next;

   procedure Get_Reception (R : out Reception) is
      Current : Monitor.Session_Stages.State;
   begin
      Monitor.Session.Get (Current);
      R :=
        (case Current.Stage is
            when Monitor.Session_Stages.Free   => Vacant,
            when Monitor.Session_Stages.Active => Occupied,
            when Monitor.Session_Stages.Closing
               | Monitor.Session_Stages.Closed =>
              (if Current.Stopping then Stopping else Deferred));
   end Get_Reception;

   procedure Hear (G : in out Gate; Where : Place; R : in out Reception) is
      Now    : constant Time := Clock;
      Length : Natural;
      Open   : Boolean;
      Unused : Natural;
   begin
      Read (G, Where, Length, Open);
      if Length > 0 then
         --  the end of a connection is seen behind what was sent
         Read (G, Where, Unused, Open);
      end if;
      case Admission.Authentication.Decision (G.Places (Where).Reader) is
         when Admission.Authentication.Right =>
            Keep (G.Table, Where);
            Decide (G, Where, R);
         when Admission.Authentication.Undecided =>
            if not Open or else Now >= G.Places (Where).Limit then
               Turn_Away
                 (G, Where, Not_Authenticated, Noted_Not_Authenticated);
            end if;
         when Admission.Authentication.Wrong =>
            Turn_Away (G, Where, Not_Authenticated, Noted_Not_Authenticated);
      end case;
   end Hear;

   procedure Hear_Some
     (G     : in out Gate;
      Ready : Place_Set;
      R     : in out Reception;
      Left  : in out Work_Count)
   is
      Now   : constant Time := Clock;
      Due   : Place_Set := Ready;
      Where : Place_Choice;
   begin
      for I in Place loop
         Due (I) := Due (I) or else Now >= G.Places (I).Limit;
      end loop;
      for Step in 1 .. Schedule.Hearings_Per_Turn loop
         exit when Left = 0;
         Where := No_Place;
         if R /= Deferred then
            Where := First_Kept (G.Table);
         end if;
         if Where in Place then
            Decide (G, Where, R);
         else
            Where := Next (G.Table, Due);
            exit when Where = No_Place;
            Due (Where) := False;
            Serve (G.Table, Where);
            Hear (G, Where, R);
         end if;
         Left := Left - 1;
         pragma Loop_Invariant (Is_Consistent (G));
      end loop;
   end Hear_Some;

   procedure Let_In (G : in out Gate; Where : Place) is
      Line : Texts.Text;
      Peer : Texts.Text;
   begin
      Monitor.Sockets.Gate.Get_Name (Where, Peer);
      Monitor.Sockets.Gate.Admit (Where);
      Monitor.Outbox.Open_Session;
      Texts.Set (Line, "monitor connected from ");
      Texts.Append (Line, Texts.Image (Peer));
      Journal.Put (Options.Info, Line);
      Leave (G.Table, Where);
      Monitor.Session.Begin_Work;
   end Let_In;

   procedure Load_Token
     (Path    : Texts.Text;
      Token   : out Admission.Authentication.Token;
      Success : out Boolean;
      Reason  : out Texts.Text)
   is
      Credentials : constant String := "/run/credentials/";
      Data   : String (1 .. 256);
      Length : Natural;
      Mode   : Admission.Authentication.File_Mode;
      Owner  : Admission.Authentication.User_Number;
   begin
      Token := (others => <>);
      Texts.Set (Reason, "");
      Success := Path.Length = 0;
      if Success then
         return;
      end if;
      Admission.Secret_Files.Read
        (Path, Data, Length, Mode, Owner, Success, Reason);
      if Success then
         Success := Admission.Authentication.Is_Kept_Secret (Mode, Owner);
         if Success then
            Admission.Authentication.Read_Token
              (Data (1 .. Length), Token, Success);
            if not Success then
               Texts.Set
                 (Reason,
                  "its first line is no token: 8 .. 128 printable ASCII "
                  & "characters without a blank");
            end if;
         else
            Texts.Set
              (Reason,
               "others than its owner can read or write it (chmod go= it)");
         end if;
      end if;
      if not Success and then Path.Length > Credentials'Length
        and then Path.Data (Credentials'Range) = Credentials
      then
         Texts.Append
           (Reason,
            ". It is systemd's copy of the file to mend, "
            & "/etc/destijl/token unless LoadCredential= names another");
      end if;
   end Load_Token;

   procedure Meet
     (G     : in out Gate;
      Where : Place;
      From  : Admission.Networks.Peer_Address;
      R     : in out Reception)
   is
      Now    : constant Time := Clock;
      Excess : Place_Choice;
   begin
      if not Admission.Networks.Admits (G.Allowed, From) then
         Refuse
           (G.Refusals, Where, "this address is not allowed",
            "newcomer refused, its address is not allowed: ");
         return;
      end if;
      G.Places (Where) :=
        (From => From, Limit => Now + Schedule.Token_Limit, others => <>);
      Enter (G.Table, Where, Admission.Networks.Source_Of (From));
      if G.Token.Length = 0 then
         Keep (G.Table, Where);
         Decide (G, Where, R);
      else
         Hear (G, Where, R);
      end if;
      if Is_Taken (G.Table, Where) then
         Excess := Surplus (G.Table, Where);
         if Excess in Place then
            Turn_Away
              (G, Excess, Not_Authenticated, Noted_Not_Authenticated);
         end if;
      end if;
   end Meet;

   procedure Put_Unwritten (L : in out Refusal_Log) is
      Line : Texts.Text;
   begin
      if L.Unwritten > 0 then
         Texts.Set (Line, "newcomers refused, too many for the log: ");
         Texts.Append (Line, L.Unwritten);
         Journal.Put (Options.Warning, Line);
         L.Unwritten := 0;
      end if;
   end Put_Unwritten;

   procedure Read
     (G      : in out Gate;
      Where  : Place;
      Length : out Natural;
      Open   : out Boolean)
   is
      Data  : String (1 .. Admission.Authentication.Max_Line) :=
        (others => ' ');
      N     : Newcomer := G.Places (Where);
      Taken : Natural := 0;
   begin
      Monitor.Sockets.Gate.Look (Where, Data, Length, Open);
      for I in 1 .. Length loop
         exit when not Admission.Authentication.Is_Open (N.Reader);
         Admission.Authentication.Accept_Character
           (N.Reader, G.Token, Data (I));
         Taken := I;
         pragma Loop_Invariant (N.From = G.Places (Where).From);
         pragma Loop_Invariant
           (if Admission.Authentication.Decision (N.Reader) =
                 Admission.Authentication.Right
            then Admission.Authentication.Is_Right (N.Reader, G.Token));
         pragma Loop_Invariant (Taken = I);
      end loop;
      if Taken > 0 then
         Monitor.Sockets.Gate.Take (Where, Taken);
      end if;
      G.Places (Where) := N;
   end Read;

   procedure Refuse
     (L       : in out Refusal_Log;
      Where   : Place;
      Message : String;
      Noted   : String)
   is
      Now  : constant Time := Clock;
      Line : Texts.Text;
      Peer : Texts.Text;
   begin
      Monitor.Sockets.Gate.Refuse
        (Where, "MSSG:refused: " & Message & ASCII.LF);
      if Now - Schedule.Refusal_Pause >= L.Last then
         Put_Unwritten (L);
         L.Lines := Max_Lines;
      end if;
      L.Last := Now;
      if L.Lines > 0 and then L.Turn_Lines > 0 then
         Monitor.Sockets.Gate.Get_Name (Where, Peer);
         Texts.Set (Line, Noted);
         Texts.Append (Line, Texts.Image (Peer));
         Journal.Put (Options.Warning, Line);
         L.Lines := L.Lines - 1;
         L.Turn_Lines := L.Turn_Lines - 1;
      elsif L.Unwritten < Natural'Last then
         L.Unwritten := L.Unwritten + 1;
      end if;
   end Refuse;

   procedure Serve (G : in out Gate) is
      Watched : Place_Set;
      Ready   : Place_Set;
      Listens : Boolean;
      Queued  : Boolean;
      Woken   : Boolean;
      Limit   : Time;
      R       : Reception;
      Left    : Work_Count := Work_Count'Last;
      Changed : Boolean;
   begin
      delay until G.Rest;
      Get_Next (G, Watched, Listens, Limit);
      Monitor.Sockets.Gate.Wait
        (Watched, Listens, Limit, Ready, Queued, Woken);
      Trace.Take_Up (Schedule.Th_Server);
      if Woken then
         --  no newcomer: whoever has waited for it is seen to at once
         Close_Session;
         Trace.Done (Schedule.Th_Server);
         return;
      end if;
      Get_Reception (R);
      G.Refusals.Lines :=
        Line_Count'Min (G.Refusals.Lines, Max_Lines - 1) + 1;
      G.Refusals.Turn_Lines := Turn_Line_Count'Last;
      Hear_Some (G, Ready, R, Left);
      Defend (G.Floods, Changed);
      --  to give the kernel another filter takes as long as to take some in
      if Queued and then not Changed then
         Take_In_Some (G, R, Left);
      end if;
      Limit := Clock;
      if G.Refusals.Unwritten > 0
        and then Limit - Schedule.Refusal_Pause >= G.Refusals.Last
      then
         Put_Unwritten (G.Refusals);
      end if;
      G.Rest := Limit + Schedule.Newcomer_Interval;
      Trace.Done (Schedule.Th_Server);
   end Serve;

   procedure Set_Up
     (G       : out Gate;
      Allowed : Admission.Networks.List;
      Token   : Admission.Authentication.Token) is
   begin
      G := (Allowed => Allowed, Token => Token, others => <>);
   end Set_Up;

   procedure Take_In_Some
     (G : in out Gate; First : Reception; Most : Work_Count)
   is
      R      : Reception  := First;
      Left   : Work_Count := Most;
      Where  : Place_Choice;
      From   : Admission.Networks.Peer_Address;
      Event  : Monitor.Sockets.Gate.Arrival;
      Reason : Texts.Text;
      Line   : Texts.Text;
   begin
      while Left > 0 loop
         pragma Loop_Invariant (Is_Consistent (G));
         Where := Free_Place (G.Table);
         exit when Where = No_Place;
         Monitor.Sockets.Gate.Take_In (Where, From, Event, Reason);
         case Event is
            when Monitor.Sockets.Gate.Newcomer =>
               Admission.Blocklists.Note
                 (G.Floods.Arrivals, Admission.Networks.Source_Of (From));
               Meet (G, Where, From, R);
            when Monitor.Sockets.Gate.Nobody_There =>
               Admission.Blocklists.Clear (G.Floods.Arrivals);
               exit;
            when Monitor.Sockets.Gate.Failed =>
               Texts.Set (Line, "a monitor could not connect: ");
               Texts.Append (Line, Texts.Image (Reason));
               Journal.Put (Options.Error, Line);
               --  out of descriptors, most likely: not at full speed
               G.Pause := Clock;
               G.Pause := G.Pause + Schedule.Accept_Pause;
               exit;
         end case;
         Left := Left - 1;
      end loop;
   end Take_In_Some;

   procedure Turn_Away
     (G       : in out Gate;
      Where   : Place;
      Message : String;
      Noted   : String) is
   begin
      Refuse (G.Refusals, Where, Message, Noted);
      Leave (G.Table, Where);
   end Turn_Away;

end Admission.Newcomers;
