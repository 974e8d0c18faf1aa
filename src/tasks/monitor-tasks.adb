--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time;    use Ada.Real_Time;
with Admission.Authentication;
with Admission.Newcomers;
with Admission.Secret_Files;
with Commands; use Commands;
with Console;
with Journal;
with Missions.Requests;
with Monitor.Image_Messages;
with Monitor.Link;
with Monitor.Mailboxes;
with Monitor.Outbox;
with Monitor.Paths;
with Monitor.Protocol; use Monitor.Protocol;
with Monitor.Send_Order;
with Monitor.Session;
with Monitor.Sockets.Connection;
with Monitor.Sockets.Gate;
with Monitor.Sockets.Listener;
with Options;
with Orders;
with Process.Threads;
with Robot.Line;
with Robot.Requests;
with Robot.Service;
with Robot.Users;
with Settings;
with Texts;
with Trace;
with Vision.Camera_Requests;
with Vision.Frame_Store;
with Vision.State;
with Vision.Turns;

package body Monitor.Tasks with SPARK_Mode is

   use type Monitor.Link.Cause;
   use type Monitor.Send_Order.Choice;

   procedure Start_Server (Gate : out Admission.Newcomers.Gate) is
      --  Listens, or says why it cannot and ends the process (F1)
      Chosen  : Options.Values renames Settings.Command_Line.Chosen;
      Token   : Admission.Authentication.Token;
      Bound   : Options.Port_Number;
      Success : Boolean;
      Reason  : Texts.Text;
      Line    : Texts.Text;
   begin
      Admission.Secret_Files.Read_Token (Chosen.Token_File, Token, Reason);
      Gate := Admission.Newcomers.New_Gate (Chosen.Allowed, Token);
      if Token.Length = 0 and then Chosen.Token_File.Length > 0 then
         Texts.Set (Line, "destijl: cannot use the token file ");
         Texts.Append (Line, Texts.Image (Chosen.Token_File));
         Texts.Append (Line, ": ");
         Texts.Append (Line, Texts.Image (Reason));
         Console.Put_Log (Texts.Image (Line));
         Process.Leave (Process.Cannot_Start);
      end if;
      Monitor.Sockets.Listener.Listen
        (Chosen.Bind, Chosen.Port, Bound, Success, Reason);
      if Success then
         Texts.Set (Line, "listening on ");
      else
         Texts.Set (Line, "destijl: cannot listen on ");
         Bound := Chosen.Port;
      end if;
      Texts.Append (Line, Texts.Image (Chosen.Bind));
      Texts.Append (Line, ":");
      Texts.Append (Line, Bound);
      if Success then
         Texts.Append (Line, ", for ");
         Texts.Append (Line, Options.Admitted (Chosen));
         Journal.Put (Options.Info, Line);
         Monitor.Session.Listening.Set;
      else
         Texts.Append (Line, ": ");
         Texts.Append (Line, Texts.Image (Reason));
         Console.Put_Log (Texts.Image (Line));
         Process.Leave (Process.Cannot_Start);
      end if;
   end Start_Server;

   task body Th_Server is
      Gate : Admission.Newcomers.Gate;
   begin
      Process.Threads.Name_Task (Schedule.Th_Server);
      Monitor.Session.Server_Allowed.Wait;
      Start_Server (Gate);
      loop
         Admission.Newcomers.Serve (Gate);
      end loop;
   end Th_Server;

   procedure Ask_For_Mission (Line : String; Order : in out Orders.Order)
   with
     Pre  => Line'First = 1
       and then Line'Last <= Max_Line
       and then Order.Owed
       and then Order.Command.Name in Mission_Command,
     Post => not Order.Owed
   is
      --  Passes the path in Line on to th_mission, or rejects the order if a
      --  mission is under way
      Name  : constant Mission_Command := Order.Command.Name;
      Path  : Missions.Path;
      Valid : Boolean;
   begin
      Monitor.Paths.Parse
        (Line, Line'First + Text_Offset, Measure (Name), Is_Single (Name),
         Path, Valid);
      if Valid then
         Missions.Requests.Put (Order, Path);
      end if;
      if Order.Owed then
         Monitor.Outbox.Answer (Order, Monitor.Protocol.Refused);
      end if;
   end Ask_For_Mission;

   procedure Handle
     (Line  : String;
      Order : in out Orders.Order;
      Open  : out Boolean)
   with
     Pre  => Line'First = 1
       and then Line'Last <= Max_Line
       and then not Order.Owed,
     Post => not Order.Owed
   is
      --  One line of the monitor: its message becomes Order, which is answered
      --  here or goes to its task. Not Open: the session has ended
      Text : Texts.Text;
      Kept : Boolean;
   begin
      Parse (Line, Order.Command);
      Journal.Get_Kept (Options.Debug, Kept);
      if Kept and then Order.Command.Name /= Sign_Of_Life then
         Texts.Set (Text, "received ");
         Admission.Authentication.Append_Shown (Text, Line);
         Journal.Put (Options.Debug, Text);
      end if;
      Monitor.Outbox.Reserve (Order);
      Open := Order.Owed;
      if Open then
         Trace.Received (Order.Command.Name, Order.Number);
         case Order.Command.Name is
            when Mission_Command =>
               Ask_For_Mission (Line, Order);
            when Robot_Command =>
               Robot.Line.Put (Order);
            when Vision_Command =>
               Vision.Turns.Put (Order);
            when Sign_Of_Life =>
               Monitor.Sockets.Connection.Expect_Life;
               Monitor.Outbox.Answer (Order, No_Line);
            when Log_Message =>
               Monitor.Outbox.Answer (Order, No_Line);
               Texts.Set (Text, "monitor says: ");
               Admission.Authentication.Append_Shown
                 (Text, Line (Line'First + Text_Offset .. Line'Last));
               Journal.Put (Options.Info, Text);
            when Malformed   =>
               Monitor.Outbox.Answer (Order, Not_Understood);
               Texts.Set (Text, "not understood: ");
               Admission.Authentication.Append_Shown (Text, Line);
               Journal.Put (Options.Warning, Text);
         end case;
      end if;
   end Handle;

   procedure Tell_Stranger (Line : String)
   with
     Pre => Line'First = 1 and then Line'Last <= Max_Line
   is
      --  Into the log: a client has begun with Line
      Text : Texts.Text;
   begin
      Texts.Set
        (Text, "closing the connection of a client that is no monitor; it "
         & "begins with: ");
      Admission.Authentication.Append_Shown (Text, Line);
      Journal.Put (Options.Warning, Text);
   end Tell_Stranger;

   task body Th_Receive_From_Mon is
      Incoming : String (1 .. 4096) := (others => ' ');
      Line     : String (1 .. Max_Line) := (others => ' ');
      Length   : Natural;
      Last     : Natural;
      Reader   : Line_Reader;
      Complete : Boolean;
      Open     : Boolean;
      Begun    : Beginning;
      Order    : Orders.Order;
   begin
      Process.Threads.Name_Task (Schedule.Th_Receive_From_Mon);
      loop
         pragma Loop_Invariant (not Order.Owed);
         Monitor.Session.Receive_Begins.Wait;
         Reader := (others => <>);
         --  the right token was a line of this protocol
         Begun :=
           (if Settings.Command_Line.Chosen.Token_File.Length > 0 then Known
            else Undecided);
         loop
            pragma Loop_Invariant (not Order.Owed);
            Monitor.Sockets.Connection.Receive (Incoming, Length, Open);
            Trace.Take_Up (Schedule.Th_Receive_From_Mon);
            if Begun = Undecided and then Open then
               Judge (Reader, Incoming (1 .. Length), Begun, Line, Last);
               if Begun = Unknown then
                  Tell_Stranger (Line (1 .. Last));
                  exit;
               end if;
            end if;
            for I in 1 .. Length loop
               pragma Loop_Invariant (not Order.Owed);
               exit when not Open;
               Accept_Character (Reader, Incoming (I), Complete);
               if Complete then
                  Get_Line (Reader, Line, Last);
                  Handle (Line (1 .. Last), Order, Open);
               end if;
            end loop;
            exit when not Open;
            Trace.Done (Schedule.Th_Receive_From_Mon);
         end loop;
         --  the watch sees it, whatever ended the connection
         Monitor.Sockets.Connection.Shut_Down;
         Monitor.Session.Receive_Ended.Set;
         Trace.Done (Schedule.Th_Receive_From_Mon);
      end loop;
   end Th_Receive_From_Mon;

   procedure Send
     (Next  : in out Monitor.Mailboxes.Item;
      Image : access constant Monitor.Image_Messages.Message)
   with
     Pre  => Next.Unsent and then Next.Kind /= Monitor.Send_Order.Nothing,
     Post => not Next.Unsent
   is
      --  Image: the message, where it is one of an image
      Success : Boolean;
   begin
      if Next.Is_Image and then Image = null then
         --  never, as images go round; but no proof knows it
         Next.Unsent := False;
         return;
      elsif Next.Is_Image then
         Monitor.Sockets.Connection.Send
           (Image.Data, Image.Length, Next.Unsent, Success);
         Trace.Sent (Image.Data (1 .. 4));
      else
         Monitor.Sockets.Connection.Send
           (Next.Line.Data, Next.Line.Length, Next.Unsent, Success);
         Trace.Sent (Next.Line.Data (1 .. 4));
      end if;
      --  before the session may end: the next has a connection, too
      if not Success then
         Monitor.Sockets.Connection.Shut_Down;
      end if;
   end Send;

   task body Th_Send_To_Mon is
      Between   : Monitor.Send_Order.Milliseconds renames
        Settings.Command_Line.Chosen.Message_Gap;
      Last_Sent : Time := Time_First;
      Gap       : Monitor.Send_Order.Milliseconds;
      Hold_End  : Time := Time_Last;
      Next_Look : Time;
      Now       : Time;
      Next      : Monitor.Mailboxes.Item;
      Image     : Monitor.Image_Messages.Message_Access :=
        new Monitor.Image_Messages.Message;
      Begun     : Boolean;
   begin
      Process.Threads.Name_Task (Schedule.Th_Send_To_Mon);
      loop
         pragma Loop_Invariant (not Next.Unsent);
         Monitor.Outbox.Wait (Hold_End);
         Begun := False;
         loop
            pragma Loop_Invariant (not Next.Unsent);
            Monitor.Outbox.Take
              (Between, Last_Sent, Next, Image, Gap, Hold_End);
            exit when not Next.Unsent and then Gap = 0;
            if not Begun then
               Trace.Start (Schedule.Th_Send_To_Mon);
            end if;
            Begun := not Next.Unsent;
            if Next.Unsent then
               Send (Next, Image);
               Last_Sent := Clock;
               Trace.Done (Schedule.Th_Send_To_Mon);
            else
               --  an answer that comes meanwhile has a shorter gap
               Now := Clock;
               Next_Look := Now + Milliseconds (Monitor.Send_Order.Answer_Gap);
               if Last_Sent + Milliseconds (Gap) < Next_Look then
                  Next_Look := Last_Sent + Milliseconds (Gap);
               end if;
               Trace.Wait (Schedule.Th_Send_To_Mon, Trace.Gap);
               delay until Next_Look;
               Trace.Resume (Schedule.Th_Send_To_Mon, Next_Look);
            end if;
         end loop;
         Trace.Done (Schedule.Th_Send_To_Mon);
         Trace.Idle (Schedule.Th_Send_To_Mon);
      end loop;
   end Th_Send_To_Mon;

   procedure Wait_Loss (Why : out Monitor.Link.Cause)
   with Post => Why /= Monitor.Link.Nothing
   is
      --  Until the monitor in command is lost
      Seconds  : constant Options.Silence_Seconds :=
        Settings.Command_Line.Chosen.Silence;
      Patience : constant Monitor.Link.Milliseconds :=
        (if Seconds = 0 then Monitor.Link.Milliseconds'Last
         else Monitor.Link.Milliseconds (1_000 * Seconds));
      Link    : Monitor.Link.State;
      Sample  : Monitor.Link.Sample;
      Verdict : Monitor.Link.Verdict := Monitor.Link.Present;
      Loss    : Monitor.Link.Loss_Kind;
      Known   : Monitor.Session.Status;
      Line    : Texts.Text;
      Now     : Time;
   begin
      Monitor.Sockets.Connection.Sample (Patience, Sample);
      if not Sample.Known then
         Monitor.Sockets.Connection.Leave_To_Kernel;
         Texts.Set
           (Line, "no TCP_INFO, keep-alive instead: a monitor is lost that "
            & "vanishes, or takes nothing, for ");
         Monitor.Link.Append_Seconds (Line, Monitor.Link.Vanished_After);
         Texts.Append (Line, "; signs of life are not watched");
         Journal.Put (Options.Warning, Line);
      end if;
      Monitor.Link.Start (Link, Sample.Now);
      loop
         Monitor.Sockets.Connection.Watch (Schedule.Link_Period, Loss);
         Trace.Take_Up (Schedule.Th_Com_Mon_Perdue);
         Monitor.Session.State.Get (Known);
         Monitor.Sockets.Connection.Sample (Patience, Sample);
         if Sample.Known then
            Monitor.Link.Judge (Link, Sample, Verdict);
         end if;
         Why := Monitor.Link.Cause_Of (Known.Stopping, Loss, Verdict);
         exit when Why /= Monitor.Link.Nothing;
         Now := Clock;
         Vision.Frame_Store.Look_At_Silence (Now);
         Trace.Done (Schedule.Th_Com_Mon_Perdue);
      end loop;
   end Wait_Loss;

   procedure Bring_Back is
      --  Robot, camera and queues to their initial state (F6)
      Next    : Orders.Ticket;
      Stopped : Boolean;
      Ignored : Commands.Outcome;
      Idle    : Boolean;
      Limit   : Time;
      Now     : Time;
   begin
      --  the robot first: from here on no order of this session counts
      Monitor.Sockets.Connection.Shut_Down;
      Monitor.Outbox.Close_Session (Next);
      Robot.Line.Begin_Session (Next);
      Robot.Line.Ask
        (Robot.Requests.Safe_State,
         (Kind => Commands.Close_Line, others => <>), (others => <>));
      loop
         Robot.Users.Monitor_Lost.Wait_In_Job;
         Robot.Service.Serve (Schedule.Th_Com_Mon_Perdue, Ignored, Stopped);
         exit when Stopped;
      end loop;
      Vision.State.Store.Begin_Session (Next);
      Vision.Camera_Requests.Requests.Close;
      --  a search for the arena does not wait for a camera that hangs
      Vision.Frame_Store.End_Delivery;
      Monitor.Outbox.Wait_Sender;
      Trace.Wait (Schedule.Th_Com_Mon_Perdue, Trace.Tasks);
      Monitor.Session.Receive_Ended.Wait;
      Trace.Resume (Schedule.Th_Com_Mon_Perdue);
      Vision.Turns.Clear;
      --  a camera that hangs in its driver is not waited for: it closes as
      --  soon as the driver lets go of it
      Now := Clock;
      Limit := Now + Schedule.Camera_Release_Limit;
      loop
         Vision.Camera_Requests.Requests.Get_Idle (Idle);
         exit when Idle;
         Now := Clock;
         exit when Now >= Limit;
         Trace.Wait (Schedule.Th_Com_Mon_Perdue, Trace.Camera);
         delay until Now + Schedule.Release_Poll;
         Trace.Resume (Schedule.Th_Com_Mon_Perdue);
      end loop;
   end Bring_Back;

   task body Th_Com_Mon_Perdue is
      Why  : Monitor.Link.Cause;
      Line : Texts.Text;
   begin
      Process.Threads.Name_Task (Schedule.Th_Com_Mon_Perdue);
      loop
         Monitor.Session.Watch_Begins.Wait;
         Wait_Loss (Why);
         Monitor.Session.State.Go_On (Monitor.Session.Closing);
         Texts.Set (Line, "monitor lost: ");
         Monitor.Link.Append (Line, Why);
         Journal.Put (Options.Warning, Line);
         Bring_Back;
         Monitor.Sockets.Connection.Close;
         Journal.Put
           (Options.Info, "session closed, ready for a new monitor");
         Monitor.Session.State.Go_On (Monitor.Session.Free);
         Monitor.Sockets.Gate.Wake_Server;
         Trace.Done (Schedule.Th_Com_Mon_Perdue);
      end loop;
   end Th_Com_Mon_Perdue;

end Monitor.Tasks;
