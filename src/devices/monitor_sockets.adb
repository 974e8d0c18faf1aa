--  SPDX-License-Identifier: GPL-3.0-or-later
--  The TCP server for the monitor: a listening socket, the connection of the
--  monitor in command, and newcomers that are to be admitted or refused.

with Ada.Exceptions;
with Ada.Real_Time; use Ada.Real_Time;
with Ada.Streams;   use Ada.Streams;
with Bytes;        use Bytes;
with GNAT.OS_Lib;
with GNAT.Sockets;  use GNAT.Sockets;
with Interfaces;    use Interfaces;
with Interfaces.C;  use Interfaces.C;
with Linux;         use Linux;
with System;

package body Monitor_Sockets with
  SPARK_Mode    => Off,
  Refined_State =>
    (Network => (Listener, Waiting, Peers, Current, Waker))
is

   use type Monitor_Link.Milliseconds;

   Nobody   : constant int := -1;
   Listener : int := Nobody with Atomic;  --  takes connections
   Current  : int := Nobody with Atomic;  --  the monitor's in command
   Waker    : int := Nobody with Atomic;  --  an event counter: Wake_Server

   Waiting : array (Place) of int := (others => Nobody)
     with Atomic_Components;
   --  the newcomers'

   type Peer is record
      Is_IPv4 : Boolean := True;  --  of the socket, not of the address
      Address : Networks.Peer_Address := (others => 0);
      Port    : Unsigned_16 := 0;
   end record;

   Peers : array (Place) of Peer;
   --  theirs

   Listening : constant Positive := Place'Last + 1;
   Waking    : constant Positive := Place'Last + 2;
   --  beside the places: numbers of what th_server waits for

   Send_Buffer : constant := 65_536;
   --  Bytes; the kernel doubles it. More, and seconds of old images would
   --  wait there for a slow monitor

   Receive_Buffer : constant := 65_536;
   --  Bytes; the kernel doubles it, for what it needs itself. It does not
   --  grow then: whoever sends faster than the robot drives has hundreds of
   --  commands waiting here and not a megabyte

   Queue_Length : constant := 512;
   --  Of those who wait to be taken in. Whoever finds the kernel's queue full
   --  tries again later and later, and may do so for ever. So it is empty
   --  before Schedule.Block_Time is over: with 1,024 it was not, and amid a
   --  flood it took up to 2.4 s to be admitted, now 0.3 s

   Send_Flags    : constant := 16#4000#;  --  MSG_NOSIGNAL
   Send_With_End : constant := 16#C040#;  --  and MSG_DONTWAIT, MSG_MORE
   Look_Now      : constant := 16#42#;    --  MSG_PEEK and MSG_DONTWAIT
   Receive_Now   : constant := 16#40#;    --  MSG_DONTWAIT
   Both_Ways     : constant := 2;         --  SHUT_RDWR
   Attach_Filter : constant := 26;        --  SO_ATTACH_FILTER
   Detach_Filter : constant := 27;        --  SO_DETACH_FILTER
   Level_Tcp     : constant := 6;         --  IPPROTO_TCP
   Level_Socket  : constant := 1;         --  SOL_SOCKET
   Error_Option  : constant := 4;         --  SO_ERROR
   Info_Option   : constant := 11;        --  TCP_INFO
   Idle_Option   : constant := 4;         --  TCP_KEEPIDLE
   Repeat_Option : constant := 5;         --  TCP_KEEPINTVL
   Quick_Option  : constant := 12;        --  TCP_QUICKACK
   Count_Option  : constant := 6;         --  TCP_KEEPCNT
   Wait_Option   : constant := 18;        --  TCP_USER_TIMEOUT

   function C_Send
     (Fd : int; Data : System.Address; Length : size_t; Flags : int)
      return Ssize
   with Import, Convention => C, External_Name => "send";

   function C_Receive
     (Fd : int; Data : System.Address; Length : size_t; Flags : int)
      return Ssize
   with Import, Convention => C, External_Name => "recv";

   function C_Shutdown (Fd : int; How : int) return int
   with Import, Convention => C, External_Name => "shutdown";

   function Get_Option
     (Fd     : int;
      Level  : int;
      Name   : int;
      Value  : System.Address;
      Length : System.Address) return int
   with Import, Convention => C, External_Name => "getsockopt";

   function Set_Option
     (Fd     : int;
      Level  : int;
      Name   : int;
      Value  : System.Address;
      Length : unsigned) return int
   with Import, Convention => C, External_Name => "setsockopt";

   function C_Accept
     (Fd      : int;
      Address : System.Address;
      Length  : System.Address;
      Flags   : int) return int
   with Import, Convention => C, External_Name => "accept4";

   --  struct sockaddr_in, sockaddr_in6: the port and the address of IPv4 in
   --  the order of the network
   type Socket_Address is record
      Family  : Unsigned_16 := 0;
      Port    : Stream_Element_Array (1 .. 2) := (others => 0);
      Host_V4 : Byte_Array (1 .. 4) := (others => 0);
      Host_V6 : Byte_Array (1 .. 16) := (others => 0);
      Scope   : Unsigned_32 := 0;
   end record with Convention => C;

   Inet_Family : constant := 2;  --  AF_INET

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

   function Event_Counter (Initial : unsigned; Flags : int) return int
   with Import, Convention => C, External_Name => "eventfd";

   --  The beginning of the kernel's struct tcp_info (linux/tcp.h)
   type Word_Array is array (Positive range <>) of Unsigned_32
     with Convention => C;

   type Tcp_Info is record
      States      : Word_Array (1 .. 6);   --  states, times, segment sizes
      Unacked     : Unsigned_32;           --  segments; where it listens,
      Selected    : Unsigned_32;           --  its queue's length and limit
      Counters    : Word_Array (1 .. 5);   --  up to the last one sent
      Last_Data   : Unsigned_32;           --  ms since the last received
      Last_Ack    : Unsigned_32;           --  ms since the last received
      Metrics     : Word_Array (1 .. 11);
      Pacing      : Word_Array (1 .. 4);
      Bytes_Acked : Unsigned_64;
      Bytes_Got   : Unsigned_64;
      Segments    : Word_Array (1 .. 2);
      Not_Sent    : Unsigned_32;           --  bytes
      Shortest    : Unsigned_32;
   end record with Convention => C, Size => 152 * 8;

   procedure Set_Number (Fd : int; Level : int; Name : int; Value : int);
   --  A socket option; a kernel without it leaves its own default

   ----------------
   -- Set_Number --
   ----------------

   procedure Set_Number (Fd : int; Level : int; Name : int; Value : int) is
      Number  : constant int := Value;
      Ignored : constant int :=
        Set_Option (Fd, Level, Name, Number'Address, 4);
      pragma Unreferenced (Ignored);
   begin
      null;
   end Set_Number;

   ------------
   -- Listen --
   ------------

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
      --  a newcomer that is gone again must not block the accept
      Control_Socket (Server, Non_Blocking);
      Bound := Natural (Get_Socket_Name (Server).Port);
      Waker := Event_Counter (0, 8#4000#);  --  EFD_NONBLOCK
      Listener := int (To_C (Server));
      Success := True;
   exception
      when E : others =>
         Texts.Set (Reason, Ada.Exceptions.Exception_Message (E));
         if Server /= No_Socket then
            Linux.Close (int (To_C (Server)));
         end if;
         Success := False;
   end Listen;

   -----------
   -- Block --
   -----------

   procedure Block (Sources : Blocklists.List) is
      --  A program for the kernel's filter, which a packet to the listening
      --  socket passes first. A jump goes on at the next step but so many
      Load_Byte : constant := 16#30#;
      Load_Half : constant := 16#28#;
      Load_Word : constant := 16#20#;
      And_With  : constant := 16#54#;
      If_Equal  : constant := 16#15#;
      Return_It : constant := 16#06#;
      Protocol  : constant := 16#FFFF_F000#;  --  SKF_AD_PROTOCOL
      Header    : constant := 16#FFF0_0000#;  --  SKF_NET_OFF: that of IP
      IPv4      : constant := 16#0800#;
      Program   : Filter_Array (1 .. 8 + 5 * Blocklists.Max_Sources);
      Last      : Natural := 0;
      Described : Filter_Program;
      Ignored   : int;
      pragma Unreferenced (Ignored);

      procedure Add
        (Code     : Unsigned_16;
         Operand  : Unsigned_32;
         If_True  : Natural := 0;
         If_False : Natural := 0);

      procedure Add
        (Code     : Unsigned_16;
         Operand  : Unsigned_32;
         If_True  : Natural := 0;
         If_False : Natural := 0) is
      begin
         Last := Last + 1;
         Program (Last) :=
           (Code, Unsigned_8 (If_True), Unsigned_8 (If_False), Operand);
      end Add;

      procedure Add_Sources (Of_IPv4 : Boolean);

      procedure Add_Sources (Of_IPv4 : Boolean) is
         Source : Networks.Source;
      begin
         for I in 1 .. Sources.Count loop
            Source := Sources.Items (I);
            if Networks.Is_IPv4 (Source) = Of_IPv4 then
               if Of_IPv4 then
                  Add (Load_Word, Header + 12);
               else
                  Add (Load_Word, Header + 8);
                  Add (If_Equal, Unsigned_32 (Shift_Right (Source, 32)),
                       If_False => 3);
                  Add (Load_Word, Header + 12);
               end if;
               Add (If_Equal, Unsigned_32 (Source and 16#FFFF_FFFF#),
                    If_False => 1);
               Add (Return_It, 0);
            end if;
         end loop;
      end Add_Sources;

      Others_Begin : Positive;
   begin
      if Sources.Count = 0 then
         Set_Number (Listener, Level_Socket, Detach_Filter, 0);
         return;
      end if;
      --  only what begins a connection: SYN without ACK
      Add (Load_Byte, 13);
      Add (And_With, 16#12#);
      Add (If_Equal, 16#02#, If_True => 1);
      Add (Return_It, Unsigned_32'Last);
      Add (Load_Half, Protocol);
      Add (If_Equal, IPv4);
      Others_Begin := Last;
      Add_Sources (Of_IPv4 => True);
      Add (Return_It, Unsigned_32'Last);
      Program (Others_Begin).If_False := Unsigned_8 (Last - Others_Begin);
      Add_Sources (Of_IPv4 => False);
      Add (Return_It, Unsigned_32'Last);
      Described := (unsigned_short (Last), Program'Address);
      Ignored := Set_Option
        (Listener, Level_Socket, Attach_Filter,
         Described'Address, Described'Size / 8);
   end Block;

   --------------
   -- Get_Name --
   --------------

   procedure Get_Name (Where : Place; Peer : out Texts.Text) is
      Seen : Monitor_Sockets.Peer renames Peers (Where);
      Host : Inet_Addr_Type
        (if Seen.Is_IPv4 then Family_Inet else Family_Inet6);
   begin
      case Host.Family is
         when Family_Inet =>
            for I in Host.Sin_V4'Range loop
               Host.Sin_V4 (I) := Inet_Addr_Comp_Type (Seen.Address (12 + I));
            end loop;
         when Family_Inet6 =>
            for I in Host.Sin_V6'Range loop
               Host.Sin_V6 (I) := Inet_Addr_Comp_Type (Seen.Address (I));
            end loop;
      end case;
      Texts.Set
        (Peer,
         Image (Network_Socket_Address (Host, Port_Type (Seen.Port))));
   end Get_Name;

   ---------------
   -- Get_Queue --
   ---------------

   procedure Get_Queue (Length, Limit : out Natural) is
      Info : Tcp_Info;
      Size : unsigned := Tcp_Info'Size / 8;
   begin
      Length := 0;
      Limit := Queue_Length;
      if Get_Option (Listener, Level_Tcp, Info_Option,
                     Info'Address, Size'Address) = 0
        and then Size >= Info.Counters'Position  --  else not known
      then
         Length := Natural (Info.Unacked);
         Limit := Natural (Info.Selected);
      end if;
   end Get_Queue;

   -------------
   -- Take_In --
   -------------

   procedure Take_In
     (Where  : Place;
      From   : out Networks.Peer_Address;
      Event  : out Arrival;
      Reason : out Texts.Text)
   is
      Address : Socket_Address;
      Size    : unsigned := Socket_Address'Size / 8;
      Fd      : constant int :=
        C_Accept (Listener, Address'Address, Size'Address, 0);
      Is_IPv4 : constant Boolean := Address.Family = Inet_Family;
   begin
      Texts.Set (Reason, "");
      From :=
        (if Is_IPv4
         then (1 .. 10 => 0, 11 .. 12 => 255) & Address.Host_V4
         else Address.Host_V6);
      if Fd >= 0 then
         Waiting (Where) := Fd;
         Peers (Where) :=
           (Is_IPv4, From,
            Unsigned_16 (Address.Port (1)) * 256
            + Unsigned_16 (Address.Port (2)));
         Event := Newcomer;
      elsif GNAT.OS_Lib.Errno = EAGAIN then
         --  a newcomer that has gone already is no failure
         Event := Nobody_There;
      else
         Texts.Set (Reason, GNAT.OS_Lib.Errno_Message);
         Event := Failed;
      end if;
   end Take_In;

   ----------
   -- Wait --
   ----------

   procedure Wait
     (Watched    : Place_Set;
      Listens    : Boolean;
      Until_Time : Ada.Real_Time.Time;
      Ready      : out Place_Set;
      Queued     : out Boolean;
      Woken      : out Boolean)
   is
      Entries : Poll_Array (1 .. Waking) := (others => (Nobody, Poll_In, 0));
      Left    : Time_Span;
      Wait_Ms : int := -1;
      Ignored : int;
      Count   : Unsigned_64 := 0;
      Taken   : Ssize;
      pragma Unreferenced (Ignored, Taken);
   begin
      for I in Place loop
         if Watched (I) then
            Entries (I).Descriptor := Waiting (I);
         end if;
      end loop;
      if Listens then
         Entries (Listening).Descriptor := Listener;
      end if;
      Entries (Waking).Descriptor := Waker;
      if Until_Time /= Time_Last then
         Left := Until_Time - Clock;
         --  to the next millisecond: not awake too early again and again
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

   -----------------
   -- Wake_Server --
   -----------------

   procedure Wake_Server is
      One     : constant Unsigned_64 := 1;
      Written : constant Ssize := Linux.Write (Waker, One'Address, 8);
      pragma Unreferenced (Written);
   begin
      null;
   end Wake_Server;

   ----------
   -- Look --
   ----------

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

   ----------
   -- Take --
   ----------

   procedure Take (Where : Place; Count : Natural) is
      Data    : Stream_Element_Array
        (1 .. Stream_Element_Offset (Count));
      Ignored : constant Ssize :=
        C_Receive (Waiting (Where), Data'Address, Data'Length, Receive_Now);
      pragma Unreferenced (Ignored);
   begin
      null;
   end Take;

   -----------
   -- Admit --
   -----------

   procedure Admit (Where : Place) is
      Fd : constant int := Waiting (Where);
   begin
      Set_Number (Fd, Level_Tcp, 1, 1);                 --  TCP_NODELAY
      Set_Number (Fd, Level_Socket, 7, Send_Buffer);    --  SO_SNDBUF
      Set_Number (Fd, Level_Socket, 8, Receive_Buffer); --  SO_RCVBUF
      --  an idle monitor that vanished: 1 s, then three probes of 1 s
      Set_Number (Fd, Level_Socket, 9, 1);              --  SO_KEEPALIVE
      Set_Number (Fd, Level_Tcp, Idle_Option, 1);
      Set_Number (Fd, Level_Tcp, Repeat_Option, 1);
      Set_Number (Fd, Level_Tcp, Count_Option, 3);
      Waiting (Where) := Nobody;
      Current := Fd;
   end Admit;

   ------------
   -- Refuse --
   ------------

   procedure Refuse (Where : Place; Message : String) is
      Fd      : constant int := Waiting (Where);
      Ignored : Ssize;
      Ended   : int;
      pragma Unreferenced (Ignored, Ended);
      Unread  : Stream_Element_Array (1 .. 256);
   begin
      --  one packet: the message goes out with the end, which takes half the
      --  time. There may be a flood of them
      Ignored := C_Send (Fd, Message'Address, Message'Length, Send_With_End);
      Ended := C_Shutdown (Fd, 1);  --  SHUT_WR
      --  what it has sent already would turn the close into a reset, which
      --  could overtake the message
      Ignored := C_Receive (Fd, Unread'Address, Unread'Length, Receive_Now);
      Waiting (Where) := Nobody;
      Linux.Close (Fd);
   end Refuse;

   -------------
   -- Receive --
   -------------

   procedure Receive
     (Data : in out String; Length : out Natural; Open : out Boolean)
   is
      Got : Ssize;
   begin
      Length := 0;
      --  a command that has no answer must not make a sender wait that
      --  holds the next one back until this one is acknowledged (Nagle). Now
      --  that it is on its way, for the acknowledgement takes its time, too
      Set_Number (Current, Level_Tcp, Quick_Option, 1);
      loop
         Got := C_Receive (Current, Data'Address, Data'Length, 0);
         exit when Got >= 0 or else GNAT.OS_Lib.Errno /= EINTR;
      end loop;
      Open := Got > 0;
      if Got > 0 then
         Length := Natural (Got);
      end if;
   end Receive;

   ----------
   -- Send --
   ----------

   procedure Send
     (Data : String; Length : Natural; Success : out Boolean)
   is
      Done : Natural := 0;
      Put  : Ssize;
   begin
      while Done < Length loop
         Put := C_Send (Current, Data (Data'First + Done)'Address,
                        size_t (Length - Done), Send_Flags);
         if Put > 0 then
            Done := Done + Natural (Put);
         else
            exit when Put < 0 and then GNAT.OS_Lib.Errno /= EINTR;
         end if;
      end loop;
      Success := Done = Length;
   end Send;

   -----------
   -- Watch --
   -----------

   procedure Watch (Wait : Ada.Real_Time.Time_Span; Loss : out Loss_Kind) is
      Entries : Poll_Array (1 .. 1) := (1 => (Current, Poll_Peer_Closed, 0));
      Count   : int;
      Error   : int := 0;
      Size    : unsigned := Error'Size / 8;
      Timed_Out : constant := 110;  --  ETIMEDOUT
      No_Route  : constant := 113;  --  EHOSTUNREACH
   begin
      Loss := None;
      Count := Poll
        (Entries'Address, 1, int (Integer'Max (0, Wait / Milliseconds (1))));
      if Count > 0 then
         if Get_Option (Current, Level_Socket, Error_Option,
                        Error'Address, Size'Address) = 0
           and then Size = Error'Size / 8
           and then Error in Timed_Out | No_Route
         then
            Loss := No_Sign_Of_Life;
         elsif (Unsigned_16 (Entries (1).Returned)
                and Unsigned_16 (Poll_Error + Poll_Hang_Up)) /= 0
         then
            Loss := Reset_By_Peer;
         else
            Loss := Closed_By_Peer;
         end if;
      end if;
   end Watch;

   ------------
   -- Sample --
   ------------

   procedure Sample (Link : out Monitor_Link.Sample) is
      Info  : Tcp_Info;
      Size  : unsigned := Tcp_Info'Size / 8;
      Whole : Seconds_Count;
      Rest  : Time_Span;
   begin
      --  not by a division of the time as a whole: its result, an Integer,
      --  would be too small for the milliseconds of 25 days
      Split (Clock, Whole, Rest);
      Link :=
        (Now    => Monitor_Link.Milliseconds (Whole) * 1000
           + Monitor_Link.Milliseconds (Rest / Milliseconds (1)),
         others => <>);
      if Get_Option (Current, Level_Tcp, Info_Option,
                     Info'Address, Size'Address) = 0
        and then Monitor_Link.Is_Enough (Natural (Size))
      then
         Link :=
           (Now            => Link.Now,
            Known          => True,
            Unacknowledged => Natural (Info.Unacked),
            Since_Heard    => Monitor_Link.Milliseconds
              (Unsigned_32'Min (Info.Last_Ack, Info.Last_Data)),
            Outstanding    => Natural (Info.Not_Sent + Info.Unacked),
            Bytes_Acked    => Monitor_Link.Byte_Count
              (Info.Bytes_Acked and (2 ** 63 - 1)));
      end if;
   end Sample;

   ---------------------
   -- Leave_To_Kernel --
   ---------------------

   procedure Leave_To_Kernel is
   begin
      Set_Number (Current, Level_Tcp, Wait_Option,
                  int (Monitor_Link.Vanished_After));
   end Leave_To_Kernel;

   ---------------
   -- Shut_Down --
   ---------------

   procedure Shut_Down is
      Ignored : constant int := C_Shutdown (Current, Both_Ways);
      pragma Unreferenced (Ignored);
   begin
      null;
   end Shut_Down;

   -----------
   -- Close --
   -----------

   procedure Close is
      Fd : constant int := Current;
   begin
      Current := Nobody;
      Linux.Close (Fd);
   end Close;

end Monitor_Sockets;
