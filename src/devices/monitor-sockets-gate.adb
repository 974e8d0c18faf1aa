--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Exceptions;
with Ada.Real_Time;         use Ada.Real_Time;
with Ada.Streams;           use Ada.Streams;
with Bytes;                 use Bytes;
with GNAT.OS_Lib;
with GNAT.Sockets;          use GNAT.Sockets;
with Interfaces;            use Interfaces;
with Interfaces.C;          use Interfaces.C;
with Linux;                 use Linux;
with Monitor.Sockets.Calls; use Monitor.Sockets.Calls;
with System;

package body Monitor.Sockets.Gate with
  SPARK_Mode    => Off,
  Refined_State => (Newcomers => (Listener, Waker, Waiting, Peers))
is

   Listener : Socket := Nobody with Atomic;  --  accepts connections
   Waker    : int := -1 with Atomic;         --  an event counter: Wake_Server

   Waiting : array (Place) of Socket := (others => Nobody)
     with Atomic_Components;
   --  sockets of the pending connections

   Listening : constant Positive := Place'Last + 1;
   Waking    : constant Positive := Place'Last + 2;
   --  indices of the other descriptors that th_server waits for

   Queue_Length : constant := 512;
   --  Backlog of connections not yet accepted. A client that finds it full
   --  retries at growing intervals. So it must be emptied within
   --  Schedule.Block_Time: with 1,024 it was not, and during a flood an
   --  admission took up to 2.4 s, now 0.3 s

   Send_With_End : constant := 16#C040#;
   --  MSG_NOSIGNAL, MSG_DONTWAIT, MSG_MORE
   Look_Now      : constant := 16#42#;  --  MSG_PEEK and MSG_DONTWAIT
   Receive_Now   : constant := 16#40#;  --  MSG_DONTWAIT
   Attach_Filter : constant := 26;      --  SO_ATTACH_FILTER
   Detach_Filter : constant := 27;      --  SO_DETACH_FILTER

   function C_Accept
     (From : Socket; Address, Size : System.Address; Flags : int)
      return Socket
   with Import, Convention => C, External_Name => "accept4";

   --  struct sockaddr_in, sockaddr_in6: port and IPv4 address in network byte
   --  order
   type Socket_Address is record
      Family  : Unsigned_16 := 0;
      Port    : Stream_Element_Array (1 .. 2) := (others => 0);
      Host_V4 : Byte_Array (1 .. 4) := (others => 0);
      Host_V6 : Byte_Array (1 .. 16) := (others => 0);
      Scope   : Unsigned_32 := 0;
   end record with Convention => C;

   Inet_Family : constant := 2;  --  AF_INET

   Peers : array (Place) of Socket_Address;
   --  addresses of the pending connections

   --  struct sock_filter, sock_fprog (linux/filter.h)
   type Filter_Step is record
      Code     : Unsigned_16;
      If_True  : Unsigned_8;
      If_False : Unsigned_8;
      Operand  : Unsigned_32;
   end record with Convention => C;

   type Filter_Array is array (Positive range <>) of Filter_Step
     with Convention => C;

   type Filter_Program is record
      Length : unsigned_short;
      Steps  : System.Address;
   end record with Convention => C;

   procedure Listen
     (Address : Texts.Text;
      Port    : Options.Port_Number;
      Bound   : out Options.Port_Number;
      Success : out Boolean;
      Reason  : out Texts.Text)
   is
      Server : Socket_Type := No_Socket;
      Place  : Sock_Addr_Type;
      Non_Blocking : Request_Type := (Non_Blocking_IO, True);
   begin
      Bound := 0;
      Texts.Set (Reason, "");
      declare
         Host : constant Inet_Addr_Type := Inet_Addr (Texts.Image (Address));
      begin
         Place := Network_Socket_Address (Host, Port_Type (Port));
         Create_Socket (Server, Host.Family, Socket_Stream);
      end;
      Set_Socket_Option (Server, Socket_Level, (Reuse_Address, True));
      Bind_Socket (Server, Place);
      Listen_Socket (Server, Queue_Length);
      --  a client that has left again must not block the accept
      Control_Socket (Server, Non_Blocking);
      Bound := Natural (Get_Socket_Name (Server).Port);
      Waker := Event_Counter (0, Event_Non_Blocking);
      Listener := Socket (To_C (Server));
      Success := True;
   exception
      when E : others =>
         Texts.Set (Reason, Ada.Exceptions.Exception_Message (E));
         if Server /= No_Socket then
            Linux.Close (int (To_C (Server)));
         end if;
         Success := False;
   end Listen;

   procedure Block (Sources : Admission.Blocklists.List) is
      --  A BPF program: the kernel applies it to each packet to the listening
      --  socket. A jump skips the given number of steps
      Load_Byte : constant := 16#30#;
      Load_Half : constant := 16#28#;
      Load_Word : constant := 16#20#;
      And_With  : constant := 16#54#;
      If_Equal  : constant := 16#15#;
      Return_It : constant := 16#06#;
      Protocol  : constant := 16#FFFF_F000#;  --  SKF_AD_PROTOCOL
      Header    : constant := 16#FFF0_0000#;  --  SKF_NET_OFF: that of IP
      IPv4      : constant := 16#0800#;
      Pass      : constant Filter_Step := (Return_It, 0, 0, Unsigned_32'Last);
      Start     : constant Filter_Array :=
        --  only packets that open a connection: SYN without ACK
        ((Load_Byte, 0, 0, 13),
         (And_With, 0, 0, 16#12#),
         (If_Equal, 1, 0, 16#02#),
         Pass,
         (Load_Half, 0, 0, Protocol),
         (If_Equal, 0, 0, IPv4));  --  else past IPv4, set below
      Program   : Filter_Array
        (1 .. Start'Length + 2 + 5 * Admission.Blocklists.Max_Sources);
      Last      : Natural := 0;
      Described : Filter_Program;

      procedure Add (Steps : Filter_Array);

      procedure Add (Steps : Filter_Array) is
      begin
         Program (Last + 1 .. Last + Steps'Length) := Steps;
         Last := Last + Steps'Length;
      end Add;
   begin
      if Sources.Count = 0 then
         Set_Option (Listener, Level_Socket, Detach_Filter, Last'Address, 4);
         return;
      end if;
      Add (Start);
      for Of_IPv4 in reverse Boolean loop
         for Source of Sources.Items (1 .. Sources.Count) loop
            if Admission.Networks.Is_IPv4 (Source) = Of_IPv4 then
               if not Of_IPv4 then
                  Add (((Load_Word, 0, 0, Header + 8),
                        (If_Equal, 0, 3,
                         Unsigned_32 (Shift_Right (Source, 32)))));
               end if;
               Add (((Load_Word, 0, 0, Header + 12),
                     (If_Equal, 0, 1, Unsigned_32 (Source and 16#FFFF_FFFF#)),
                     (Return_It, 0, 0, 0)));
            end if;
         end loop;
         Add ((1 => Pass));
         if Of_IPv4 then
            Program (Start'Length).If_False :=
              Unsigned_8 (Last - Start'Length);
         end if;
      end loop;
      Described := (unsigned_short (Last), Program'Address);
      Set_Option (Listener, Level_Socket, Attach_Filter,
                  Described'Address, Described'Size / 8);
   end Block;

   procedure Get_Name (Where : Place; Peer : out Texts.Text) is
      Seen : Socket_Address renames Peers (Where);
      Host : Inet_Addr_Type
        (if Seen.Family = Inet_Family then Family_Inet else Family_Inet6);
   begin
      case Host.Family is
         when Family_Inet =>
            for I in Host.Sin_V4'Range loop
               Host.Sin_V4 (I) := Inet_Addr_Comp_Type (Seen.Host_V4 (I));
            end loop;
         when Family_Inet6 =>
            for I in Host.Sin_V6'Range loop
               Host.Sin_V6 (I) := Inet_Addr_Comp_Type (Seen.Host_V6 (I));
            end loop;
      end case;
      Texts.Set
        (Peer,
         Image
           (Network_Socket_Address
              (Host,
               Port_Type (Seen.Port (1)) * 256 + Port_Type (Seen.Port (2)))));
   end Get_Name;

   procedure Get_Queue (Length, Limit : out Natural) is
      Info : Tcp_Info;
      Size : unsigned := Tcp_Info'Size / 8;
   begin
      Length := 0;
      Limit := Queue_Length;
      if Get_Option (Listener, Level_Tcp, Info_Option,
                     Info'Address, Size'Address) = 0
        and then Size >= Info.Counters'Position  --  else unknown
      then
         Length := Natural (Info.Unacked);
         Limit := Natural (Info.Selected);
      end if;
   end Get_Queue;

   procedure Take_In
     (Where  : Place;
      From   : out Admission.Networks.Peer_Address;
      Event  : out Arrival;
      Reason : out Texts.Text)
   is
      Address : Socket_Address;
      Size    : unsigned := Socket_Address'Size / 8;
      Found   : constant Socket :=
        C_Accept (Listener, Address'Address, Size'Address, 0);
   begin
      Texts.Set (Reason, "");
      From :=
        (if Address.Family = Inet_Family
         then (1 .. 10 => 0, 11 .. 12 => 255) & Address.Host_V4
         else Address.Host_V6);
      if Found /= Nobody then
         Waiting (Where) := Found;
         Peers (Where) := Address;
         Event := Newcomer;
      elsif GNAT.OS_Lib.Errno = EAGAIN then
         --  the client has already left: no failure
         Event := Nobody_There;
      else
         Texts.Set (Reason, GNAT.OS_Lib.Errno_Message);
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
      Entries : Poll_Array (1 .. Waking) := (others => (-1, Poll_In, 0));
      Left    : Time_Span;
      Wait_Ms : int := -1;
      Ignored : int;
      Count   : Unsigned_64 := 0;
      Taken   : Ssize;
      pragma Unreferenced (Ignored, Taken);
   begin
      for I in Place loop
         if Watched (I) then
            Entries (I).Descriptor := int (Waiting (I));
         end if;
      end loop;
      if Listens then
         Entries (Listening).Descriptor := int (Listener);
      end if;
      Entries (Waking).Descriptor := Waker;
      if Until_Time /= Time_Last then
         Left := Until_Time - Clock;
         --  rounded up to 1 ms, to avoid repeated early wake-ups
         Wait_Ms :=
           (if Left < Time_Span_Zero then 0
            else int (Integer'Min (Left / Milliseconds (1), 60_000)) + 1);
      end if;
      Ignored := Poll (Entries'Address, Entries'Length, Wait_Ms);
      for I in Place loop
         Ready (I) := Entries (I).Returned /= 0;
      end loop;
      Queued := Entries (Listening).Returned /= 0;
      Woken := Entries (Waking).Returned /= 0;
      if Woken then
         Taken := Linux.Read (Waker, Count'Address, 8);
      end if;
   end Wait;

   procedure Wake_Server is
      One     : constant Unsigned_64 := 1;
      Written : constant Ssize := Linux.Write (Waker, One'Address, 8);
      pragma Unreferenced (Written);
   begin
      null;
   end Wake_Server;

   procedure Look
     (Where  : Place;
      Data   : in out String;
      Length : out Natural;
      Open   : out Boolean)
   is
      Got : constant Ssize :=
        C_Receive (Waiting (Where), Data'Address, Data'Length, Look_Now);
   begin
      Length := Natural (Ssize'Max (0, Got));
      Open := Got > 0
        or else (Got < 0 and then GNAT.OS_Lib.Errno in EAGAIN | EINTR);
   end Look;

   procedure Take (Where : Place; Count : Natural) is
      Data    : Stream_Element_Array (1 .. Stream_Element_Offset (Count));
      Ignored : constant Ssize :=
        C_Receive (Waiting (Where), Data'Address, Data'Length, Receive_Now);
      pragma Unreferenced (Ignored);
   begin
      null;
   end Take;

   procedure Admit (Where : Place) is
   begin
      Connection.Take_Over (Waiting (Where));
      Waiting (Where) := Nobody;
   end Admit;

   procedure Refuse (Where : Place; Message : String) is
      Refused : constant Socket := Waiting (Where);
      Ignored : Ssize;
      pragma Unreferenced (Ignored);
      Unread  : Stream_Element_Array (1 .. 256);
   begin
      --  message and FIN in one packet, which takes half the time: there may
      --  be a flood of rejections
      Ignored := C_Send
        (Refused, Message'Address, Message'Length, Send_With_End);
      C_Shutdown (Refused, 1);  --  SHUT_WR
      --  unread data would turn the close into a reset, which could overtake
      --  the message
      Ignored := C_Receive
        (Refused, Unread'Address, Unread'Length, Receive_Now);
      Waiting (Where) := Nobody;
      Linux.Close (int (Refused));
   end Refuse;

end Monitor.Sockets.Gate;
