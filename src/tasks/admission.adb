--  SPDX-License-Identifier: GPL-3.0-or-later
--  Who may be the monitor: newcomers, where they come from, the token they
--  show, and who is in command already. For th_server.

with Ada.Real_Time; use Ada.Real_Time;
with Bytes;
with Journal;
with Options;
with Outbox;
with Schedule;
with Secret_Files;
with Session;
with Trace;

package body Admission with SPARK_Mode is

   use type Authentication.Verdict;
   use type Bytes.Byte_Array;
   use type Session.Stage_Kind;

   Not_Authenticated : constant String := "not authenticated";

   Noted_Not_Authenticated : constant String :=
     "newcomer refused, not authenticated: ";

   procedure Get_Next
     (G       : Gate;
      Free    : out Monitor_Sockets.Place_Choice;
      Watched : out Monitor_Sockets.Place_Set;
      Limit   : out Time)
   with
     Post =>
       (if Free in Monitor_Sockets.Place then
           G.Places (Free).Stage = Nobody)
       and then
         (for all I in Monitor_Sockets.Place =>
            Watched (I) = (G.Places (I).Stage = Asked));
   --  What is to be waited for, and how long

   procedure Meet
     (G     : in out Gate;
      Where : Monitor_Sockets.Place;
      From  : Networks.Peer_Address;
      Peer  : Texts.Text)
   with
     Pre  => Is_Consistent (G),
     Post => Is_Consistent (G);
   --  A newcomer: asks for its token where there is one

   procedure Read (G : in out Gate; Where : Monitor_Sockets.Place)
   with
     Pre  => Is_Consistent (G) and then G.Places (Where).Stage = Asked,
     Post => Is_Consistent (G);
   --  What a newcomer has sent, up to the end of its first line

   procedure Turn_Away
     (G       : in out Gate;
      Where   : Monitor_Sockets.Place;
      Message : String;
      Noted   : String)
   with
     Pre  => Is_Consistent (G) and then Message'Length < 100,
     Post => Is_Consistent (G) and then G.Places (Where).Stage = Nobody;
   --  Tells it Message, and Noted and its address to the log

   procedure Turn_Late_Away (G : in out Gate)
   with
     Pre  => Is_Consistent (G),
     Post => Is_Consistent (G);
   --  One of those who have not shown their token in time

   procedure Close_Session;
   --  If it has been brought back: ready for the next monitor

   procedure Get_First
     (G     : Gate;
      First : out Monitor_Sockets.Place_Choice;
      Stage : out Session.Stage_Kind)
   with
     Post =>
       (if First in Monitor_Sockets.Place then
           G.Places (First).Stage = Entitled);
   --  Of those who are entitled, who came first; nobody while the end of a
   --  session is dealt with. Stage: of the session

   procedure Let_In (G : in out Gate; Where : Monitor_Sockets.Place)
   with
     Pre  => Is_Consistent (G)
       and then Is_Entitled (G, G.Places (Where)),
     Post => Is_Consistent (G) and then G.Places (Where).Stage = Nobody;
   --  It is in command now

   procedure Decide (G : in out Gate)
   with
     Pre  => Is_Consistent (G),
     Post => Is_Consistent (G);
   --  Admits the first of those entitled where nobody is in command, or
   --  tells it why not. While the end of a session is dealt with it waits

   -------------------
   -- Close_Session --
   -------------------

   procedure Close_Session is
      Stage : Session.Stage_Kind;
   begin
      Session.Get_Stage (Stage);
      if Stage = Session.Closed then
         Monitor_Sockets.Close;
         Session.End_Closed;
         Journal.Put
           (Options.Info, "session closed, ready for a new monitor");
      end if;
   end Close_Session;

   ------------
   -- Decide --
   ------------

   procedure Decide (G : in out Gate) is
      Where    : Monitor_Sockets.Place_Choice;
      Stage    : Session.Stage_Kind;
      Admitted : Boolean := False;
   begin
      Get_First (G, Where, Stage);
      if Where = Monitor_Sockets.No_Place then
         return;
      end if;
      if Stage = Session.Free then
         Session.Begin_Active (Admitted);
      end if;
      if Admitted then
         Let_In (G, Where);
      elsif Stage = Session.Active then
         Turn_Away
           (G, Where, "another monitor is connected",
            "second monitor refused: ");
      else
         Turn_Away
           (G, Where, "the supervisor is stopping",
            "monitor refused, the supervisor is stopping: ");
      end if;
   end Decide;

   ---------------
   -- Get_First --
   ---------------

   procedure Get_First
     (G     : Gate;
      First : out Monitor_Sockets.Place_Choice;
      Stage : out Session.Stage_Kind)
   is
      Stopping : Boolean;
   begin
      First := Monitor_Sockets.No_Place;
      Session.Get_Stopping (Stopping);
      Session.Get_Stage (Stage);
      if Stage in Session.Closing | Session.Closed and then not Stopping then
         return;
      end if;
      for I in Monitor_Sockets.Place loop
         if G.Places (I).Stage = Entitled
           and then (First = Monitor_Sockets.No_Place
                     or else G.Places (I).Limit < G.Places (First).Limit)
         then
            First := I;
         end if;
         pragma Loop_Invariant
           (if First in Monitor_Sockets.Place then
               G.Places (First).Stage = Entitled);
      end loop;
   end Get_First;

   --------------
   -- Get_Next --
   --------------

   procedure Get_Next
     (G       : Gate;
      Free    : out Monitor_Sockets.Place_Choice;
      Watched : out Monitor_Sockets.Place_Set;
      Limit   : out Time)
   is
      Now    : Time;
      First  : Monitor_Sockets.Place_Choice;
      Unused : Session.Stage_Kind;
   begin
      Free := Monitor_Sockets.No_Place;
      Watched := (others => False);
      Limit := Time_Last;
      for I in Monitor_Sockets.Place loop
         case G.Places (I).Stage is
            when Nobody =>
               Free := I;
            when Asked =>
               Watched (I) := True;
               if G.Places (I).Limit < Limit then
                  Limit := G.Places (I).Limit;
               end if;
            when Entitled =>
               null;
         end case;
         pragma Loop_Invariant
           (if Free in Monitor_Sockets.Place then
               G.Places (Free).Stage = Nobody);
         pragma Loop_Invariant
           (for all J in Monitor_Sockets.Place =>
              Watched (J) = (J <= I and then G.Places (J).Stage = Asked));
      end loop;
      Now := Clock;
      if Now < G.Pause then
         Free := Monitor_Sockets.No_Place;
         if G.Pause < Limit then
            Limit := G.Pause;
         end if;
      end if;
      --  who has waited for the end of a session, or behind another
      Get_First (G, First, Unused);
      if First in Monitor_Sockets.Place then
         Limit := Now;
      end if;
   end Get_Next;

   ------------
   -- Let_In --
   ------------

   procedure Let_In (G : in out Gate; Where : Monitor_Sockets.Place) is
      Line : Texts.Text;
   begin
      Monitor_Sockets.Admit (Where);
      Outbox.Open_Session;
      Texts.Set (Line, "monitor connected from ");
      Texts.Append (Line, Texts.Image (G.Places (Where).Peer));
      Journal.Put (Options.Info, Line);
      G.Places (Where) := (others => <>);
      Session.Begin_Work;
   end Let_In;

   ----------------
   -- Load_Token --
   ----------------

   procedure Load_Token
     (Path    : Texts.Text;
      Token   : out Authentication.Token;
      Success : out Boolean;
      Reason  : out Texts.Text)
   is
      Data   : String (1 .. 256);
      Length : Natural;
      Mode   : Authentication.File_Mode;
      Owner  : Authentication.User_Number;
   begin
      Token := (others => <>);
      Texts.Set (Reason, "");
      Success := Path.Length = 0;
      if Success then
         return;
      end if;
      Secret_Files.Read
        (Path, Data, Length, Mode, Owner, Success, Reason);
      if Success then
         Success := Authentication.Is_Kept_Secret (Mode, Owner);
         if Success then
            Authentication.Read_Token (Data (1 .. Length), Token, Success);
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
   end Load_Token;

   ----------
   -- Meet --
   ----------

   procedure Meet
     (G     : in out Gate;
      Where : Monitor_Sockets.Place;
      From  : Networks.Peer_Address;
      Peer  : Texts.Text)
   is
      Now : Time;
      N   : Newcomer;
   begin
      Now := Clock;
      N := (From => From, Peer => Peer, Limit => Now + Schedule.Token_Limit,
            others => <>);
      if Networks.Admits (G.Allowed, From) then
         N.Stage := (if G.Token.Length > 0 then Asked else Entitled);
         G.Places (Where) := N;
      else
         G.Places (Where) := N;
         Turn_Away
           (G, Where, "this address is not allowed",
            "newcomer refused, its address is not allowed: ");
      end if;
   end Meet;

   ----------
   -- Read --
   ----------

   procedure Read (G : in out Gate; Where : Monitor_Sockets.Place) is
      Data   : String (1 .. Authentication.Max_Line) := (others => ' ');
      Length : Natural;
      Open   : Boolean;
      N      : Newcomer := G.Places (Where);
      Taken  : Natural := 0;
   begin
      Monitor_Sockets.Look (Where, Data, Length, Open);
      for I in 1 .. Length loop
         Authentication.Accept_Character (N.Reader, G.Token, Data (I));
         Taken := I;
         exit when Authentication.Decision (N.Reader)
           /= Authentication.Undecided;
         pragma Loop_Invariant (Authentication.Is_Open (N.Reader));
         pragma Loop_Invariant
           (N.Stage = Asked and then N.From = G.Places (Where).From);
         pragma Loop_Invariant (Taken = I);
      end loop;
      if Taken > 0 then
         Monitor_Sockets.Take (Where, Taken);
      end if;
      case Authentication.Decision (N.Reader) is
         when Authentication.Right =>
            N.Stage := Entitled;
            G.Places (Where) := N;
         when Authentication.Undecided =>
            G.Places (Where) := N;
            if not Open then
               Turn_Away
                 (G, Where, Not_Authenticated, Noted_Not_Authenticated);
            end if;
         when Authentication.Wrong =>
            Turn_Away (G, Where, Not_Authenticated, Noted_Not_Authenticated);
      end case;
   end Read;

   -----------
   -- Serve --
   -----------

   procedure Serve (G : in out Gate) is
      Free    : Monitor_Sockets.Place_Choice;
      Watched : Monitor_Sockets.Place_Set;
      Limit   : Time;
      Event   : Monitor_Sockets.Arrival;
      Where   : Monitor_Sockets.Place;
      From    : Networks.Peer_Address;
      Peer    : Texts.Text;
      Line    : Texts.Text;
   begin
      delay until G.Rest;
      Get_Next (G, Free, Watched, Limit);
      Monitor_Sockets.Wait_Newcomer
        (Free, Watched, Limit, Event, Where, From, Peer);
      Trace.Take_Up (Schedule.Th_Server);
      case Event is
         when Monitor_Sockets.Newcomer =>
            Meet (G, Where, From, Peer);
         when Monitor_Sockets.Input =>
            Read (G, Where);
         when Monitor_Sockets.Woken =>
            --  no newcomer: whoever has waited for it is seen to at once
            Close_Session;
            Trace.Done (Schedule.Th_Server);
            return;
         when Monitor_Sockets.Failed =>
            Texts.Set (Line, "a monitor could not connect: ");
            Texts.Append (Line, Texts.Image (Peer));
            Journal.Put (Options.Error, Line);
            --  out of descriptors, most likely: not at full speed
            G.Pause := Clock;
            G.Pause := G.Pause + Schedule.Accept_Pause;
         when Monitor_Sockets.Nothing =>
            null;
      end case;
      Turn_Late_Away (G);
      Decide (G);
      G.Rest := Clock;
      G.Rest := G.Rest + Schedule.Newcomer_Interval;
      Trace.Done (Schedule.Th_Server);
   end Serve;

   ------------
   -- Set_Up --
   ------------

   procedure Set_Up
     (G       : out Gate;
      Allowed : Networks.List;
      Token   : Authentication.Token) is
   begin
      G := (Allowed => Allowed, Token => Token, others => <>);
   end Set_Up;

   ---------------
   -- Turn_Away --
   ---------------

   procedure Turn_Away
     (G       : in out Gate;
      Where   : Monitor_Sockets.Place;
      Message : String;
      Noted   : String)
   is
      Line : Texts.Text;
   begin
      Monitor_Sockets.Refuse
        (Where, "MSSG:refused: " & Message & ASCII.LF);
      Texts.Set (Line, Noted);
      Texts.Append (Line, Texts.Image (G.Places (Where).Peer));
      Journal.Put (Options.Warning, Line);
      G.Places (Where) := (others => <>);
   end Turn_Away;

   --------------------
   -- Turn_Late_Away --
   --------------------

   procedure Turn_Late_Away (G : in out Gate) is
      Now : Time;
   begin
      Now := Clock;
      for I in Monitor_Sockets.Place loop
         pragma Loop_Invariant (Is_Consistent (G));
         if G.Places (I).Stage = Asked and then Now >= G.Places (I).Limit then
            Turn_Away (G, I, Not_Authenticated, Noted_Not_Authenticated);
            exit;
         end if;
      end loop;
   end Turn_Late_Away;

end Admission;
