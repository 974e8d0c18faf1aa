--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time;         use Ada.Real_Time;
with GNAT.OS_Lib;
with Interfaces;            use Interfaces;
with Interfaces.C;          use Interfaces.C;
with Linux;                 use Linux;
with Monitor.Sockets.Calls; use Monitor.Sockets.Calls;

package body Monitor.Sockets.Connection with
  SPARK_Mode    => Off,
  Refined_State => (Peer => Current)
is

   use type Monitor.Link.Milliseconds;

   Current : Socket := Nobody with Atomic;

   Send_Buffer : constant := 65_536;
   --  Bytes; the kernel doubles it. A larger one would hold seconds of old
   --  images for a slow monitor

   Receive_Buffer : constant := 65_536;
   --  Bytes; the kernel doubles it for its own needs, and no longer adapts it.
   --  So a monitor that sends faster than the robot executes has hundreds of
   --  commands waiting here, not a megabyte

   Send_Flags    : constant := 16#4000#;  --  MSG_NOSIGNAL
   Both_Ways     : constant := 2;         --  SHUT_RDWR
   Error_Option  : constant := 4;         --  SO_ERROR
   Idle_Option   : constant := 4;         --  TCP_KEEPIDLE
   Repeat_Option : constant := 5;         --  TCP_KEEPINTVL
   Quick_Option  : constant := 12;        --  TCP_QUICKACK
   Count_Option  : constant := 6;         --  TCP_KEEPCNT
   Wait_Option   : constant := 18;        --  TCP_USER_TIMEOUT

   procedure Set_Number (S : Socket; Level, Name, Value : int);

   procedure Set_Number (S : Socket; Level, Name, Value : int) is
   begin
      Set_Option (S, Level, Name, Value'Address, 4);
   end Set_Number;

   procedure Take_Over (Newcomer : Socket) is
   begin
      Set_Number (Newcomer, Level_Tcp, 1, 1);                 --  TCP_NODELAY
      Set_Number (Newcomer, Level_Socket, 7, Send_Buffer);    --  SO_SNDBUF
      Set_Number (Newcomer, Level_Socket, 8, Receive_Buffer); --  SO_RCVBUF
      --  detects an idle peer that vanished: 1 s, then three probes of 1 s
      Set_Number (Newcomer, Level_Socket, 9, 1);              --  SO_KEEPALIVE
      Set_Number (Newcomer, Level_Tcp, Idle_Option, 1);
      Set_Number (Newcomer, Level_Tcp, Repeat_Option, 1);
      Set_Number (Newcomer, Level_Tcp, Count_Option, 3);
      Current := Newcomer;
   end Take_Over;

   procedure Receive
     (Data : in out String; Length : out Natural; Open : out Boolean)
   is
      Got : Ssize;
   begin
      --  acknowledge at once: a sender with Nagle's algorithm holds its next
      --  command back until this one, which may have no answer, is
      --  acknowledged
      Set_Number (Current, Level_Tcp, Quick_Option, 1);
      loop
         Got := C_Receive (Current, Data'Address, Data'Length, 0);
         exit when Got >= 0 or else GNAT.OS_Lib.Errno /= EINTR;
      end loop;
      Open := Got > 0;
      Length := Natural (Ssize'Max (0, Got));
   end Receive;

   procedure Send
     (Data    : String;
      Length  : Natural;
      Unsent  : in out Boolean;
      Success : out Boolean)
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
      Unsent := False;
   end Send;

   procedure Watch
     (Wait : Ada.Real_Time.Time_Span; Loss : out Monitor.Link.Loss_Kind)
   is
      Entries : Poll_Array (1 .. 1) :=
        (1 => (int (Current), Poll_Peer_Closed, 0));
      Count   : int;
      Error   : int := 0;
      Size    : unsigned := Error'Size / 8;
      Timed_Out : constant := 110;  --  ETIMEDOUT
      No_Route  : constant := 113;  --  EHOSTUNREACH
   begin
      Loss := Monitor.Link.None;
      Count := Poll
        (Entries'Address, 1, int (Integer'Max (0, Wait / Milliseconds (1))));
      if Count > 0 then
         Loss :=
           (if Get_Option (Current, Level_Socket, Error_Option,
                           Error'Address, Size'Address) = 0
              and then Size = Error'Size / 8
              and then Error in Timed_Out | No_Route
            then Monitor.Link.No_Sign_Of_Life
            elsif (Unsigned_16 (Entries (1).Returned)
                   and Unsigned_16 (Poll_Error + Poll_Hang_Up)) /= 0
            then Monitor.Link.Reset_By_Peer
            else Monitor.Link.Closed_By_Peer);
      end if;
   end Watch;

   procedure Sample (Link : out Monitor.Link.Sample) is
      Info  : Tcp_Info;
      Size  : unsigned := Tcp_Info'Size / 8;
      Whole : Seconds_Count;
      Rest  : Time_Span;
   begin
      --  no division of the whole time: its result is an Integer, which
      --  overflows after 25 days of milliseconds
      Split (Clock, Whole, Rest);
      Link :=
        (Now    => Monitor.Link.Milliseconds (Whole) * 1000
           + Monitor.Link.Milliseconds (Rest / Milliseconds (1)),
         others => <>);
      if Get_Option (Current, Level_Tcp, Info_Option,
                     Info'Address, Size'Address) = 0
        and then Monitor.Link.Is_Enough (Natural (Size))
      then
         Link :=
           (Now            => Link.Now,
            Known          => True,
            Unacknowledged => Natural (Info.Unacked),
            Since_Heard    => Monitor.Link.Milliseconds
              (Unsigned_32'Min (Info.Last_Ack, Info.Last_Data)),
            Outstanding    => Natural (Info.Not_Sent + Info.Unacked),
            Bytes_Acked    => Monitor.Link.Byte_Count
              (Info.Bytes_Acked and (2 ** 63 - 1)));
      end if;
   end Sample;

   procedure Leave_To_Kernel is
   begin
      Set_Number (Current, Level_Tcp, Wait_Option,
                  int (Monitor.Link.Vanished_After));
   end Leave_To_Kernel;

   procedure Shut_Down is
   begin
      C_Shutdown (Current, Both_Ways);
   end Shut_Down;

   procedure Close is
      Closed : constant Socket := Current;
   begin
      Current := Nobody;
      Linux.Close (int (Closed));
   end Close;

end Monitor.Sockets.Connection;
