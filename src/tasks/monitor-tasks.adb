--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time;    use Ada.Real_Time;
with Admission;
with Admission.Newcomers;
with Admission.Secret_Files;
with Command_Lines;
with Commands; use Commands;
with Console;
with Journal;
with Missions.Requests;
with Monitor.Link;
with Monitor.Mailboxes;
with Monitor.Outbox;
with Monitor.Protocol; use Monitor.Protocol;
with Monitor.Session;
with Monitor.Sockets.Connection;
with Options;
with Process.Threads;
with Robot.Line;
with Robot.Requests;
with Robot.Service;
with Texts;
with Trace;
with Vision.Frames;
with Vision.State;
with Vision.Turns;

package body Monitor.Tasks with SPARK_Mode is

   use type Monitor.Link.Cause;
   use type Monitor.Mailboxes.Choice;
   use type Monitor.Outbox.Message_Access;

   procedure Start_Server (Gate : out Admission.Newcomers.Gate) is
      --  Listens, or says why it cannot and ends the process (F1)
      Chosen  : Options.Values renames Command_Lines.Given.Chosen;
      Token   : Admission.Token;
      Bound   : Options.Port_Number;
      Success : Boolean;
      Reason  : Texts.Text;
      Line    : Texts.Text;
   begin
      Admission.Secret_Files.Read_Token (Chosen.Token_File, Token, Reason);
      Gate := Admission.Newcomers.New_Gate (Chosen.Allowed, Token);
      if Token.Length = 0 and then Chosen.Token_File.Length > 0 then
         Console.Cannot_Start
           ("cannot use the token file " & Texts.Image (Chosen.Token_File)
            & ": " & Texts.Image (Reason));
      end if;
      Monitor.Sockets.Listen
        (Chosen.Bind, Chosen.Port, Bound, Success, Reason);
      Texts.Set (Line, Texts.Image (Chosen.Bind));
      Texts.Append (Line, ":");
      Texts.Append (Line, (if Success then Bound else Chosen.Port));
      if not Success then
         Console.Cannot_Start
           ("cannot listen on " & Texts.Image (Line) & ": "
            & Texts.Image (Reason));
      end if;
      Journal.Put
        (Options.Info,
         "listening on " & Texts.Image (Line) & ", for "
         & Options.Admitted (Chosen));
      Monitor.Session.Listening.Set;
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

   procedure Ask_For_Mission (Line : String; Order : in out Commands.Order)
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
      if Has_Data (Line) then
         Monitor.Protocol.Parse
           (Line, Line'First + Text_Offset, Measure (Name),
            Most_Points (Name), Path, Valid);
         if Valid then
            Missions.Requests.Put (Order, Path);
         end if;
      end if;
      if Order.Owed then
         Monitor.Outbox.Answer (Order, Monitor.Protocol.Refused);
      end if;
   end Ask_For_Mission;

   procedure Log (Level : Options.Level; What, Line : String)
   with
     Pre => Line'First > 0 and then Line'Last <= Max_Line
   is
      --  What, and what the monitor or another client has sent
      Text : Texts.Text;
   begin
      Texts.Set (Text, What);
      Admission.Append_Shown (Text, Line);
      Journal.Put (Level, Texts.Image (Text));
   end Log;

   procedure Handle
     (Line  : String;
      Order : in out Commands.Order;
      Open  : out Boolean)
   with
     Pre  => Line'First = 1
       and then Line'Last <= Max_Line
       and then not Order.Owed,
     Post => not Order.Owed
   is
      --  One line of the monitor: its message becomes Order, which is answered
      --  here or goes to its task. Not Open: the session has ended
   begin
      Parse (Line, Order.Command);
      if Journal.Is_Kept (Options.Debug)
        and then Order.Command.Name /= Sign_Of_Life
      then
         Log (Options.Debug, "received ", Line);
      end if;
      Monitor.Outbox.Reserve (Order);
      Open := Order.Owed;
      if Open then
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
               Log (Options.Info, "monitor says: ",
                    Line (Line'First + Text_Offset .. Line'Last));
            when Malformed   =>
               Monitor.Outbox.Answer (Order, Not_Understood);
               Log (Options.Warning, "not understood: ", Line);
         end case;
      end if;
   end Handle;

   task body Th_Receive_From_Mon is
      Incoming : String (1 .. 4096) := (others => ' ');
      Line     : Line_Buffer := (others => ' ');
      Length   : Natural;
      Last     : Line_Length;
      Reader   : Line_Reader;
      Complete : Boolean;
      Open     : Boolean;
      Begun    : Beginning;
      Order    : Commands.Order;
   begin
      Process.Threads.Name_Task (Schedule.Th_Receive_From_Mon);
      loop
         pragma Loop_Invariant (not Order.Owed);
         Monitor.Session.Receive_Begins.Wait;
         Reader := (others => <>);
         --  the right token was a line of this protocol
         Begun :=
           (if Command_Lines.Given.Chosen.Token_File.Length > 0 then Known
            else Undecided);
         loop
            pragma Loop_Invariant (not Order.Owed);
            Monitor.Sockets.Connection.Receive (Incoming, Length, Open);
            if Begun = Undecided and then Open then
               Judge (Reader, Incoming (1 .. Length), Begun, Line, Last);
               if Begun = Unknown then
                  Log (Options.Warning,
                       "closing the connection of a client that is no "
                       & "monitor; it begins with: ", Line (1 .. Last));
                  exit;
               end if;
            end if;
            for I in 1 .. Length loop
               pragma Loop_Invariant (not Order.Owed);
               exit when not Open;
               Accept_Character (Reader, Incoming (I), Complete);
               if Complete then
                  Get_Line (Reader, Line, Last);
                  Reader := (others => <>);
                  Handle (Line (1 .. Last), Order, Open);
               end if;
            end loop;
            exit when not Open;
         end loop;
         --  the watch sees it, whatever ended the connection
         Monitor.Sockets.Connection.Shut_Down;
         Monitor.Session.Receive_Ended.Set;
      end loop;
   end Th_Receive_From_Mon;

   procedure Send
     (Next  : in out Monitor.Mailboxes.Item;
      Image : Monitor.Outbox.Message)
   with
     Pre  => Next.Unsent and then Next.Kind /= Monitor.Mailboxes.Nothing,
     Post => not Next.Unsent
   is
      --  Image: the message, where it is one of an image
      Success : Boolean;
   begin
      if Next.Is_Image then
         Monitor.Sockets.Connection.Send
           (Image.Data, Image.Length, Next.Unsent, Success);
      else
         Monitor.Sockets.Connection.Send
           (Next.Line.Data, Next.Line.Length, Next.Unsent, Success);
      end if;
      --  before the session may end: the next has a connection, too
      if not Success then
         Monitor.Sockets.Connection.Shut_Down;
      end if;
   end Send;

   task body Th_Send_To_Mon is
      Between   : Monitor.Mailboxes.Milliseconds renames
        Command_Lines.Given.Chosen.Message_Gap;
      Last_Sent : Time := Time_First;
      Next_Look : Time;
      Now       : Time;
      Next      : Monitor.Mailboxes.Item;
      Image     : Monitor.Outbox.Message_Access :=
        new Monitor.Outbox.Message;
   begin
      Process.Threads.Name_Task (Schedule.Th_Send_To_Mon);
      loop
         pragma Loop_Invariant (not Next.Unsent and then Image /= null);
         Monitor.Outbox.Wait (Next.Hold_End);
         loop
            pragma Loop_Invariant (not Next.Unsent and then Image /= null);
            Monitor.Outbox.Take (Between, Last_Sent, Next, Image);
            exit when not Next.Unsent and then Next.Gap = 0;
            if Next.Unsent then
               Send (Next, Image.all);
               Last_Sent := Clock;
            else
               --  an answer that comes meanwhile has a shorter gap
               Now := Clock;
               Next_Look := Now + Milliseconds (Monitor.Mailboxes.Answer_Gap);
               if Last_Sent + Milliseconds (Next.Gap) < Next_Look then
                  Next_Look := Last_Sent + Milliseconds (Next.Gap);
               end if;
               Process.Threads.Sleep_Until
                 (Schedule.Th_Send_To_Mon, Next_Look, Trace.Gap);
            end if;
         end loop;
      end loop;
   end Th_Send_To_Mon;

   procedure Wait_Loss (Why : out Monitor.Link.Cause)
   with Post => Why /= Monitor.Link.Present
   is
      --  Until the monitor in command is lost
      Seconds  : constant Options.Silence_Seconds :=
        Command_Lines.Given.Chosen.Silence;
      Patience : constant Monitor.Link.Milliseconds :=
        (if Seconds = 0 then Monitor.Link.Milliseconds'Last
         else Monitor.Link.Milliseconds (1_000 * Seconds));
      Link    : Monitor.Link.State;
      Sample  : Monitor.Link.Sample;
      Verdict : Monitor.Link.Verdict := Monitor.Link.Present;
      Loss    : Monitor.Link.Cause;
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
         Journal.Put (Options.Warning, Texts.Image (Line));
      end if;
      Link := Monitor.Link.Started (Sample.Now);
      loop
         Monitor.Sockets.Connection.Watch (Schedule.Link_Period, Loss);
         Monitor.Session.State.Get (Known);
         Monitor.Sockets.Connection.Sample (Patience, Sample);
         if Sample.Known then
            Link := Monitor.Link.After (Link, Sample);
            Verdict := Monitor.Link.Verdict_On (Link, Sample);
         end if;
         Why := Monitor.Link.Cause_Of (Known.Stopping, Loss, Verdict);
         exit when Why /= Monitor.Link.Present;
         Now := Clock;
         Vision.Frames.Look_At_Silence (Now);
      end loop;
   end Wait_Loss;

   procedure Bring_Back is
      --  Robot, camera and queues to their initial state (F6)
      Next    : Commands.Ticket;
      Stopped : Boolean;
      Ignored : Commands.Outcome;
      Idle    : Boolean;
      Limit   : Time;
      Now     : Time;
   begin
      --  the robot first: from here on no order of this session counts
      Monitor.Sockets.Connection.Shut_Down;
      Monitor.Outbox.Close_Session (Next);
      Robot.Line.Grant.Begin_Session (Next);
      Robot.Line.Ask
        (Robot.Requests.Safe_State,
         (Kind => Commands.Close_Line, others => <>), (others => <>));
      loop
         Robot.Line.Monitor_Lost.Wait_In_Job (Trace.Line);
         Robot.Service.Serve (Schedule.Th_Com_Mon_Perdue, Ignored, Stopped);
         exit when Stopped;
      end loop;
      Vision.State.Store.Begin_Session (Next);
      --  a search for the arena does not wait for a camera that hangs
      Vision.Frames.End_Delivery;
      Monitor.Outbox.Wait_Sender;
      Monitor.Session.Receive_Ended.Wait_In_Job (Trace.Tasks);
      Vision.Turns.Clear;
      --  a camera that hangs in its driver is not waited for: it closes as
      --  soon as the driver lets go of it
      Now := Clock;
      Limit := Now + Schedule.Camera_Release_Limit;
      loop
         Vision.State.Store.Get_Idle (Idle);
         exit when Idle;
         Now := Clock;
         exit when Now >= Limit;
         Process.Threads.Sleep_Until
           (Schedule.Th_Com_Mon_Perdue, Now + Schedule.Release_Poll,
            Trace.Camera);
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
         Journal.Put (Options.Warning, Texts.Image (Line));
         Bring_Back;
         Monitor.Sockets.Connection.Close;
         Journal.Put
           (Options.Info, "session closed, ready for a new monitor");
         Monitor.Session.State.Go_On (Monitor.Session.Free);
         Admission.Newcomers.Wake_Server;
      end loop;
   end Th_Com_Mon_Perdue;

end Monitor.Tasks;
