--  SPDX-License-Identifier: GPL-3.0-or-later
--  The report's four tasks of the monitor, and the one that ends the hold on
--  unasked messages.

with Ada.Real_Time;    use Ada.Real_Time;
with Admission;
with Authentication;
with Camera_Requests;
with Console;
with Frame_Store;
with Journal;
with Monitor_Link;
with Monitor_Protocol; use Monitor_Protocol;
with Monitor_Sockets.Connection;
with Monitor_Sockets.Gate;
with Options;
with Orders;
with Process.Threads;
with Robot_Clients;
with Robot_Line;
with Robot_Session;
with Send_Order;
with Session;
with Settings;
with Task_Ports;
with Texts;
with Trace;
with Vision_State;

package body Monitor_Tasks with SPARK_Mode is

   use type Monitor_Link.Verdict;
   use type Monitor_Sockets.Connection.Loss_Kind;
   use type Orders.Ticket;
   use type Outbox.Message_Kind;

   procedure Start_Server (Gate : out Admission.Gate)
   with Post => Admission.Is_Consistent (Gate);
   --  Listens, or says why it cannot and ends the process (F1)

   procedure Handle
     (Line   : String;
      Rank   : in out Orders.Ticket;
      After  : in out Orders.Ticket;
      Open   : out Boolean)
   with Pre => Line'First = 1 and then Line'Last <= Max_Line;
   --  One line of the monitor: its message becomes an order. Rank and After
   --  are those of the last one

   procedure Wait_Loss (Reason : out Texts.Text);
   --  Until the monitor in command is lost

   procedure Bring_Back;
   --  Robot, camera and queues to their initial state (F6)

   ------------------
   -- Start_Server --
   ------------------

   procedure Start_Server (Gate : out Admission.Gate) is
      Chosen  : Options.Values;
      Token   : Authentication.Token;
      Bound   : Options.Port_Number;
      Success : Boolean;
      Reason  : Texts.Text;
      Line    : Texts.Text;
   begin
      Settings.Get (Chosen);
      Admission.Load_Token (Chosen.Token_File, Token, Success, Reason);
      Admission.Set_Up (Gate, Chosen.Allowed, Token);
      if not Success then
         Texts.Set (Line, "destijl: cannot use the token file ");
         Texts.Append (Line, Texts.Image (Chosen.Token_File));
         Texts.Append (Line, ": ");
         Texts.Append (Line, Texts.Image (Reason));
         Console.Put_Log (Texts.Image (Line));
         Process.Leave (Process.Cannot_Start);
      end if;
      Monitor_Sockets.Gate.Listen
        (Chosen.Bind, Chosen.Port, Bound, Success, Reason);
      if Success then
         Texts.Set (Line, "listening on ");
      else
         Texts.Set (Line, "destijl: cannot listen on ");
         Bound := Chosen.Port;
      end if;
      Texts.Append (Line, Chosen.Bind.Data (1 .. Chosen.Bind.Length));
      Texts.Append (Line, ":");
      Texts.Append (Line, Bound);
      if Success then
         Journal.Put (Options.Info, Line);
         Session.Server_Listens;
      else
         Texts.Append (Line, ": ");
         Texts.Append (Line, Reason.Data (1 .. Reason.Length));
         Console.Put_Log (Line.Data (1 .. Line.Length));
         Process.Leave (Process.Cannot_Start);
      end if;
   end Start_Server;

   ---------------
   -- Th_Server --
   ---------------

   task body Th_Server is
      Gate : Admission.Gate;
   begin
      Process.Threads.Name_Task ("th_server");
      Session.Wait_Server;
      Start_Server (Gate);
      loop
         pragma Loop_Invariant (Admission.Is_Consistent (Gate));
         Admission.Serve (Gate);
      end loop;
   end Th_Server;

   ------------
   -- Handle --
   ------------

   procedure Handle
     (Line   : String;
      Rank   : in out Orders.Ticket;
      After  : in out Orders.Ticket;
      Open   : out Boolean)
   is
      Order : Orders.Order;
      Text  : Texts.Text;
      Kept  : Boolean;
   begin
      Parse (Line, Order.Message);
      Journal.Get_Kept (Options.Debug, Kept);
      if Kept then
         Texts.Set (Text, "received ");
         Authentication.Append_Shown (Text, Line);
         Journal.Put (Options.Debug, Text);
      end if;
      Outbox.Reserve (Order.Number, Open);
      if not Open then
         return;
      end if;
      Trace.Received (Order.Message.Kind, Order.Number);
      if Order.Message.Kind in Open_Robot .. Get_State
        and then Order.Message.Kind /= Stop_Robot
      then
         Rank := Rank + 1;
         Order.Rank := Rank;
         Order.After := After;
         if Order.Message.Kind in Open_Robot .. Reset_Robot | Power_Off_Robot
         then
            After := Rank;
         end if;
      end if;
      case Order.Message.Kind is
         when Log_Message =>
            Outbox.Answer_Nothing (Order.Number);
            Texts.Set (Text, "monitor says: ");
            Authentication.Append_Shown
              (Text, Line (Line'First + Text_Offset .. Line'Last));
            Journal.Put (Options.Info, Text);
         when Malformed =>
            Outbox.Answer (Order.Number, Not_Understood);
            Texts.Set (Text, "not understood: ");
            Authentication.Append_Shown (Text, Line);
            Journal.Put (Options.Warning, Text);
         when others =>
            Task_Ports.Dispatch (Order);
      end case;
   end Handle;

   -------------------------
   -- Th_Receive_From_Mon --
   -------------------------

   task body Th_Receive_From_Mon is
      Incoming : String (1 .. 4096) := (others => ' ');
      Line     : String (1 .. Max_Line) := (others => ' ');
      Length   : Natural;
      Last     : Natural;
      Reader   : Line_Reader;
      Complete : Boolean;
      Open     : Boolean;
      Rank     : Orders.Ticket;
      After    : Orders.Ticket;
   begin
      Process.Threads.Name_Task ("th_receive_from");
      loop
         Session.Wait_Receive;
         Clear (Reader);
         Rank := 0;
         After := 0;
         loop
            Monitor_Sockets.Connection.Receive (Incoming, Length, Open);
            Trace.Take_Up (Schedule.Th_Receive_From_Mon);
            for I in 1 .. Length loop
               exit when not Open;
               Accept_Character (Reader, Incoming (I), Complete);
               if Complete then
                  Get_Line (Reader, Line, Last);
                  Handle (Line (1 .. Last), Rank, After, Open);
               end if;
            end loop;
            exit when not Open;
            Trace.Done (Schedule.Th_Receive_From_Mon);
         end loop;
         --  the watch sees it, whatever ended the connection
         Monitor_Sockets.Connection.Shut_Down;
         Session.Receiver_Left;
         Trace.Done (Schedule.Th_Receive_From_Mon);
      end loop;
   end Th_Receive_From_Mon;

   --------------------
   -- Th_Send_To_Mon --
   --------------------

   task body Th_Send_To_Mon is
      Chosen    : Options.Values;
      Last_Sent : Time := Time_First;
      Gap       : Send_Order.Milliseconds;
      Gap_End   : Time;
      Next_Look : Time;
      Now       : Time;
      Kind      : Outbox.Message_Kind;
      Length    : Outbox.Message_Length;
      Success   : Boolean;
   begin
      Process.Threads.Name_Task ("th_send_to_mon");
      loop
         Outbox.Wait;
         Settings.Get (Chosen);
         loop
            Outbox.Get_Gap (Chosen.Message_Gap, Gap);
            Gap_End := Last_Sent + Milliseconds (Gap);
            --  even a delay that has passed already takes its time
            Now := Clock;
            exit when Now >= Gap_End;
            --  an answer that comes meanwhile has a shorter gap
            Next_Look := Now + Milliseconds (Send_Order.Answer_Gap);
            if Gap_End < Next_Look then
               Next_Look := Gap_End;
            end if;
            Trace.Wait (Schedule.Th_Send_To_Mon, Trace.Gap);
            delay until Next_Look;
            Trace.Resume (Schedule.Th_Send_To_Mon, Next_Look);
         end loop;
         Outbox.Take (Chosen.Message_Gap, Gap, Kind, Outgoing, Length);
         if Kind /= Outbox.Nothing then
            Monitor_Sockets.Connection.Send (Outgoing, Length, Success);
            Last_Sent := Clock;
            Trace.Sent (Outgoing (1 .. 4));
            --  before the session may end: the next has a connection, too
            if not Success then
               Monitor_Sockets.Connection.Shut_Down;
            end if;
            Outbox.Sent;
         end if;
      end loop;
   end Th_Send_To_Mon;

   ---------------
   -- Wait_Loss --
   ---------------

   procedure Wait_Loss (Reason : out Texts.Text) is
      Link     : Monitor_Link.State;
      Sample   : Monitor_Link.Sample;
      Verdict  : Monitor_Link.Verdict := Monitor_Link.Present;
      Loss     : Monitor_Sockets.Connection.Loss_Kind;
      Stopping : Boolean;
      Now      : Time;
   begin
      Monitor_Sockets.Connection.Sample (Sample);
      if not Sample.Known then
         Monitor_Sockets.Connection.Leave_To_Kernel;
         Texts.Set
           (Reason, "no TCP_INFO: a monitor that vanishes, or takes nothing"
            & " for 4 s, is lost by keep-alive");
         Journal.Put (Options.Warning, Reason);
      end if;
      Monitor_Link.Start (Link, Sample.Now);
      loop
         Monitor_Sockets.Connection.Watch (Schedule.Link_Period, Loss);
         Trace.Take_Up (Schedule.Th_Com_Mon_Perdue);
         Session.Get_Stopping (Stopping);
         exit when Loss /= Monitor_Sockets.Connection.None or else Stopping;
         Monitor_Sockets.Connection.Sample (Sample);
         if Sample.Known then
            Monitor_Link.Judge (Link, Sample, Verdict);
         end if;
         exit when Verdict /= Monitor_Link.Present;
         Now := Clock;
         Frame_Store.Look_At_Silence (Now);
         Trace.Done (Schedule.Th_Com_Mon_Perdue);
      end loop;
      Texts.Set
        (Reason,
         (if Stopping then "the supervisor is stopping"
          elsif Verdict = Monitor_Link.Vanished then
             "it vanished, nothing has been acknowledged for 4 s"
          elsif Verdict = Monitor_Link.Stalled then
             "it has taken nothing for 15 s"
          else
            (case Loss is
                when Monitor_Sockets.Connection.Reset_By_Peer =>
                   "connection reset",
                when Monitor_Sockets.Connection.No_Sign_Of_Life =>
                   "it vanished, no sign of life for 4 s",
                when others => "connection closed")));
   end Wait_Loss;

   ----------------
   -- Bring_Back --
   ----------------

   procedure Bring_Back is
      Next  : Orders.Ticket;
      Idle  : Boolean;
      Limit : Time;
      Now   : Time;
   begin
      --  the robot first: from here on no order of this session counts
      Monitor_Sockets.Connection.Shut_Down;
      Outbox.Close_Session (Next);
      Robot_Line.Begin_Session (Next);
      Robot_Clients.Safe_State.Ask
        ((Kind => Robot_Session.Close_Line, others => <>));
      Vision_State.Begin_Session (Next);
      Camera_Requests.Close;
      --  a search for the arena does not wait for a camera that hangs
      Frame_Store.End_Delivery;
      Outbox.Wait_Sender;
      Session.Wait_Receiver_Left;
      Task_Ports.Clear;
      --  a camera that hangs in its driver is not waited for: it closes as
      --  soon as the driver lets go of it
      Now := Clock;
      Limit := Now + Schedule.Camera_Release_Limit;
      loop
         Camera_Requests.Get_Idle (Idle);
         exit when Idle;
         Now := Clock;
         exit when Now >= Limit;
         Trace.Wait (Schedule.Th_Com_Mon_Perdue, Trace.Camera);
         delay until Now + Schedule.Release_Poll;
         Trace.Resume (Schedule.Th_Com_Mon_Perdue);
      end loop;
   end Bring_Back;

   -----------------------
   -- Th_Com_Mon_Perdue --
   -----------------------

   task body Th_Com_Mon_Perdue is
      Reason : Texts.Text;
      Line   : Texts.Text;
   begin
      Process.Threads.Name_Task ("th_com_mon_perd");
      loop
         Session.Wait_Watch;
         Wait_Loss (Reason);
         Session.Begin_Closing;
         Texts.Set (Line, "monitor lost: ");
         Texts.Append (Line, Reason.Data (1 .. Reason.Length));
         Journal.Put (Options.Warning, Line);
         Bring_Back;
         Session.End_Closing;
         Monitor_Sockets.Gate.Wake_Server;
         Trace.Done (Schedule.Th_Com_Mon_Perdue);
      end loop;
   end Th_Com_Mon_Perdue;

   -------------
   -- Th_Hold --
   -------------

   task body Th_Hold is
      Any     : Boolean;
      At_Time : Time;
   begin
      Process.Threads.Name_Task ("th_hold");
      loop
         Outbox.Wait_Held;
         loop
            Outbox.Get_Hold_End (Any, At_Time);
            exit when not Any;
            Trace.Done (Schedule.Th_Hold);
            delay until At_Time;
            Trace.Start (Schedule.Th_Hold, At_Time);
            Outbox.End_Hold;
         end loop;
      end loop;
   end Th_Hold;

end Monitor_Tasks;
