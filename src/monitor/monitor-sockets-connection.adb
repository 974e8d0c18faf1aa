--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time;  use Ada.Real_Time;
with Interfaces;
with Interfaces.C;   use Interfaces.C;
with Schedule;
with Trace;

package body Monitor.Sockets.Connection with SPARK_Mode is

   use type Interfaces.Unsigned_16;
   use type Monitor.Link.Milliseconds;

   Current : Socket := Nobody with Atomic, Async_Readers, Async_Writers;

   Owing : Boolean := False with Atomic, Async_Readers, Async_Writers;
   --  It has announced signs of life

   type Option is record
      Level, Name, Value : int;
   end record;

   type Option_Array is array (Positive range <>) of Option;

   Usual : constant Option_Array :=
     ((Level_Tcp, 1, 1),          --  TCP_NODELAY
      --  SO_SNDBUF, bytes; the kernel doubles it. A larger one would hold
      --  seconds of old images for a slow monitor
      (Level_Socket, 7, 65_536),
      --  SO_RCVBUF, bytes; the kernel doubles it for its own needs, and no
      --  longer adapts it. So a monitor that sends faster than the robot
      --  executes has hundreds of commands waiting here, not a megabyte
      (Level_Socket, 8, 65_536),
      --  an idle peer is probed each second. Monitor.Link judges what comes
      --  of it: the kernel would give up without saying why, much later
      (Level_Socket, 9, 1),       --  SO_KEEPALIVE
      (Level_Socket, 10, 1),      --  SO_OOBINLINE, for telnet
      (Level_Tcp, 4, 1),          --  TCP_KEEPIDLE
      (Level_Tcp, 5, 1),          --  TCP_KEEPINTVL
      (Level_Tcp, 6, 20));        --  TCP_KEEPCNT

   Quick_Option : constant := 12;       --  TCP_QUICKACK
   Wait_Option  : constant := 18;       --  TCP_USER_TIMEOUT
   Send_Flags   : constant := 16#4000#; --  MSG_NOSIGNAL
   Both_Ways    : constant := 2;        --  SHUT_RDWR

   procedure Close is
      Closed : constant Socket := Current;
   begin
      Current := Nobody;
      Monitor.Sockets.Close (Closed);
   end Close;

   procedure Expect_Life is
   begin
      Owing := True;
   end Expect_Life;

   procedure Leave_To_Kernel is
      Peer_Socket : constant Socket := Current;
   begin
      Set_Number
        (Peer_Socket, Level_Tcp, Wait_Option,
         int (Monitor.Link.Vanished_After));
   end Leave_To_Kernel;

   procedure Receive
     (Data : in out String; Length : out Natural; Open : out Boolean)
   is
      From : constant Socket := Current;
      Got  : Outcome;
   begin
      --  acknowledge at once: a sender with Nagle's algorithm holds its next
      --  command back until this one, which may have no answer, is
      --  acknowledged
      Set_Number (From, Level_Tcp, Quick_Option, 1);
      Trace.Put (Trace.Done, Schedule.Th_Receive_From_Mon);
      loop
         Monitor.Sockets.Receive (From, 0, Data, Got);
         exit when Got /= Interrupted;
      end loop;
      Trace.Put (Trace.Start, Schedule.Th_Receive_From_Mon);
      Open := Got > 0;
      Length := Integer'Max (0, Got);
   end Receive;

   procedure Sample
     (Patience : Monitor.Link.Milliseconds; Link : out Monitor.Link.Sample)
   is
      Now         : constant Time := Clock;
      Peer_Socket : constant Socket := Current;
      Owes        : constant Boolean := Owing;
      Whole       : Seconds_Count;
      Rest        : Time_Span;
      Info        : Monitor.Link.Tcp_Info;
      Filled      : Natural;
   begin
      --  no division of the whole time: its result is an Integer, which
      --  overflows after 25 days of milliseconds
      Split (Now, Whole, Rest);
      Get_Info (Peer_Socket, Info, Filled);
      Whole := Seconds_Count'Max (0, Seconds_Count'Min (Whole, 2 ** 50));
      Link := Monitor.Link.Sample_Of
        (Info, Filled,
         Monitor.Link.Milliseconds (Whole) * 1_000
         + Monitor.Link.Milliseconds
             (Integer'Max (0, Integer'Min (Rest / Milliseconds (1), 999))));
      Link.Patience := (if Owes then Monitor.Link.Silent_After else Patience);
   end Sample;

   procedure Send
     (Data    : String;
      Length  : Natural;
      Unsent  : in out Boolean;
      Success : out Boolean)
   is
      To   : constant Socket := Current;
      Done : Natural := 0;
      Put  : Outcome;
   begin
      while Done < Length loop
         pragma Loop_Invariant (Done < Length);
         Monitor.Sockets.Send
           (To, Send_Flags, Data (Done + 1 .. Length), Put);
         exit when Put < 0 and then Put /= Interrupted;
         Done := Done + Integer'Max (0, Put);
      end loop;
      Success := Done = Length;
      Unsent := False;
      Trace.Put
        (Trace.Sent, Schedule.Th_Send_To_Mon, Label => Data (1 .. 4) & "  ");
   end Send;

   procedure Shut_Down is
      Peer_Socket : constant Socket := Current;
   begin
      Monitor.Sockets.Shut_Down (Peer_Socket, Both_Ways);
   end Shut_Down;

   procedure Take_Over (Newcomer : Socket) is
   begin
      for O of Usual loop
         Set_Number (Newcomer, O.Level, O.Name, O.Value);
      end loop;
      Owing := False;
      Current := Newcomer;
   end Take_Over;

   procedure Watch
     (Wait : Ada.Real_Time.Time_Span; Loss : out Monitor.Link.Cause)
   is
      Watched : constant Socket := Current;
      Entries : Watch_Array (1 .. 1) :=
        (1 => (int (Watched), Poll_Peer_Closed, 0));
      Ended   : Boolean;
      Error   : Integer := 0;
   begin
      Trace.Put (Trace.Done, Schedule.Th_Com_Mon_Perdue);
      Poll
        (Entries, int (Integer'Max (0, Wait / Milliseconds (1))));
      Trace.Put (Trace.Start, Schedule.Th_Com_Mon_Perdue);
      Ended := Entries (1).Returned /= 0;
      if Ended then
         Get_Error (Watched, Error);
      end if;
      Loss := Monitor.Link.Loss_Of
        (Ended  => Ended,
         Broken =>
           (Entries (1).Returned
            and (Poll_Error + Poll_Hang_Up)) /= 0,
         Error  => Error);
   end Watch;

end Monitor.Sockets.Connection;
