--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time;  use Ada.Real_Time;
with Admission.Packet_Filters;
with Admission.Socket_Addresses;
with Error_Texts;
with Interfaces;
with Interfaces.C;   use Interfaces.C;
with Monitor.Sockets.Gate.Listener_Calls;
with Monitor.Sockets.Stream_Calls;
with Monitor.Tcp_Infos;

package body Monitor.Sockets.Gate with
  SPARK_Mode,
  Refined_State =>
    (Newcomers => (Listener, Waker, Streams.Kernel, Listener_Calls.Kernel),
     Pending   => (Waiting, Peers))
is

   use type Interfaces.Unsigned_16;

   package Streams is new Monitor.Sockets.Stream_Calls;
   --  Of the pending connections and the listening socket

   Listener : Socket := Nobody with Atomic, Async_Readers, Async_Writers;
   --  Accepts connections

   Waker : int := -1 with Atomic, Async_Readers, Async_Writers;
   --  An event counter: Wake_Server

   type Socket_Array is array (Place) of Socket;

   type Address_Array is array (Place) of
     Admission.Socket_Addresses.Socket_Address;

   Waiting : Socket_Array := (others => Nobody);
   --  Sockets of the pending connections

   Peers : Address_Array;
   --  Addresses of the last clients

   Listening : constant Positive := Place'Last + 1;
   Waking    : constant Positive := Place'Last + 2;
   --  Indices of the other descriptors that th_server waits for

   Queue_Length : constant := 512;
   --  Backlog of connections not yet accepted. A client that finds it full
   --  retries at growing intervals. So it must be emptied within
   --  Schedule.Block_Time: with 1,024 it was not, and during a flood an
   --  admission took up to 2.4 s, now 0.3 s

   Longest_Wait : constant := 60_000;
   --  Milliseconds

   Look_Now      : constant := 16#42#;    --  MSG_PEEK, MSG_DONTWAIT
   Receive_Now   : constant := 16#40#;    --  MSG_DONTWAIT
   Send_With_End : constant := 16#C040#;
   --  MSG_NOSIGNAL, MSG_DONTWAIT, MSG_MORE
   Sending       : constant := 1;         --  SHUT_WR
   Detach_Filter : constant := 27;        --  SO_DETACH_FILTER

   function Wait_Of (Left : Time_Span) return int
   with Post => Wait_Of'Result in 0 .. Longest_Wait + 1;
   --  Milliseconds. Rounded up, to avoid repeated early wake-ups

   procedure Admit (Where : Place) is
   begin
      Connection.Take_Over (Waiting (Where));
      Waiting (Where) := Nobody;
   end Admit;

   procedure Block
     (Sources : Admission.Blocklists.List; Done : out Boolean)
   is
      To     : constant Socket := Listener;
      Filter : Admission.Packet_Filters.Program;
   begin
      if Sources.Count = 0 then
         Streams.Set_Number (To, Streams.Level_Socket, Detach_Filter, 0);
         Done := True;
      else
         Admission.Packet_Filters.Build (Sources, Filter);
         Listener_Calls.Attach (To, Filter, Done);
      end if;
   end Block;

   procedure Get_Name (Where : Place; Peer : out Texts.Text) is
      Seen : Admission.Socket_Addresses.Socket_Address renames Peers (Where);
      Host : Admission.Socket_Addresses.Host_Text;
   begin
      if Admission.Socket_Addresses.Is_IPv4 (Seen) then
         Listener_Calls.Get_Host (int (Seen.Family), Seen.Host_V4, Host);
      else
         Listener_Calls.Get_Host (int (Seen.Family), Seen.Host_V6, Host);
      end if;
      Admission.Socket_Addresses.Set_Name (Peer, Seen, Host);
   end Get_Name;

   procedure Get_Queue (Length, Limit : out Natural) is
      Server : constant Socket := Listener;
      Info   : Monitor.Tcp_Infos.Tcp_Info;
      Filled : Natural;
   begin
      Streams.Get_Info (Server, Info, Filled);
      Monitor.Tcp_Infos.Get_Queue (Info, Filled, Queue_Length, Length, Limit);
   end Get_Queue;

   procedure Listen
     (Address : Texts.Text;
      Port    : Options.Port_Number;
      Bound   : out Options.Port_Number;
      Success : out Boolean;
      Reason  : out Texts.Text)
   is
      Server  : Socket;
      Counter : int;
   begin
      Listener_Calls.Listen
        (Address, Port, Queue_Length, Server, Bound, Reason);
      Success := Server /= Nobody;
      if Success then
         Listener_Calls.New_Counter (Counter);
         Waker := Counter;
         Listener := Server;
      end if;
   end Listen;

   procedure Look
     (Where  : Place;
      Data   : in out String;
      Length : out Natural;
      Open   : out Boolean)
   is
      Got   : Streams.Outcome;
      Error : Integer;
   begin
      Streams.Receive (Waiting (Where), Look_Now, Data, Got, Error);
      Length := Integer'Max (0, Got);
      Open := Got > 0
        or else (Got < 0
                 and then Error in Streams.Try_Again | Streams.Interrupted);
   end Look;

   procedure Refuse (Where : Place; Message : String) is
      Refused       : constant Socket := Waiting (Where);
      Ignored_Data  : String (1 .. 256) := (others => ' ');
      Ignored_Count : Streams.Outcome;
      Ignored_Error : Integer;
   begin
      --  message and FIN in one packet, which takes half the time: there may
      --  be a flood of rejections
      Streams.Send
        (Refused, Send_With_End, Message, Ignored_Count, Ignored_Error);
      Streams.Shut_Down (Refused, Sending);
      --  unread data would turn the close into a reset, which could overtake
      --  the message
      Streams.Receive
        (Refused, Receive_Now, Ignored_Data, Ignored_Count, Ignored_Error);
      Waiting (Where) := Nobody;
      Streams.Close (Refused);
   end Refuse;

   procedure Take (Where : Place; Count : Natural) is
      Ignored_Data  : String (1 .. Count) := (others => ' ');
      Ignored_Count : Streams.Outcome;
      Ignored_Error : Integer;
   begin
      Streams.Receive
        (Waiting (Where), Receive_Now, Ignored_Data, Ignored_Count,
         Ignored_Error);
   end Take;

   procedure Take_In
     (Where  : Place;
      From   : out Admission.Networks.Peer_Address;
      Event  : out Arrival;
      Reason : out Texts.Text)
   is
      Server  : constant Socket := Listener;
      Address : Admission.Socket_Addresses.Socket_Address;
      Found   : Socket;
      Error   : Integer;
   begin
      Texts.Set (Reason, "");
      Listener_Calls.Accept_Next (Server, Address, Found, Error);
      From := Admission.Socket_Addresses.Peer_Of (Address);
      if Found /= Nobody then
         Waiting (Where) := Found;
         Peers (Where) := Address;
         Event := Newcomer;
      elsif Error = Streams.Try_Again then
         --  the client has already left: no failure
         Event := Nobody_There;
      else
         Error_Texts.Describe (Error, Reason);
         Event := Failed;
      end if;
   end Take_In;

   procedure Wait
     (Watched    : Place_Set;
      Listens    : Boolean;
      Until_Time : Ada.Real_Time.Time;
      Ready      : out Place_Set;
      Queued     : out Boolean;
      Woken      : out Boolean)
   is
      Server  : constant Socket := Listener;
      Counter : constant int := Waker;
      Now     : constant Time := Clock;
      Entries : Streams.Watch_Array (1 .. Waking);
   begin
      for I in Place loop
         if Watched (I) then
            Entries (I).Descriptor := int (Waiting (I));
         end if;
      end loop;
      if Listens then
         Entries (Listening).Descriptor := int (Server);
      end if;
      Entries (Waking).Descriptor := Counter;
      Streams.Poll
        (Entries,
         (if Until_Time = Time_Last then -1 else Wait_Of (Until_Time - Now)));
      Ready := (others => False);
      for I in Place loop
         Ready (I) := Watched (I) and then Entries (I).Returned /= 0;
         pragma Loop_Invariant
           (for all P in Place => (if Ready (P) then Watched (P)));
      end loop;
      Queued := Listens and then Entries (Listening).Returned /= 0;
      Woken := Entries (Waking).Returned /= 0;
      if Woken then
         Listener_Calls.Clear (Counter);
      end if;
   end Wait;

   function Wait_Of (Left : Time_Span) return int is
     (if Left < Time_Span_Zero then 0
      else int (Integer'Max (0, Integer'Min (Left / Milliseconds (1),
                                             Longest_Wait))) + 1);

   procedure Wake_Server is
      Counter : constant int := Waker;
   begin
      Listener_Calls.Add_One (Counter);
   end Wake_Server;

end Monitor.Sockets.Gate;
