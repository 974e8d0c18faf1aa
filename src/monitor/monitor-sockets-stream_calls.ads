--  SPDX-License-Identifier: GPL-3.0-or-later
--  Calls of the C library for TCP sockets: each makes one, once, and returns
--  what it returned. The gate and the connection have an instance each, with
--  the state of their own sockets.

with Interfaces;
with Interfaces.C; use Interfaces.C;
with Monitor.Link;

generic
package Monitor.Sockets.Stream_Calls with
  SPARK_Mode,
  Abstract_State =>
    (Kernel with Synchronous, External => (Async_Readers, Async_Writers)),
  Initializes => Kernel
is
   --  Values of Error (errno)
   Interrupted : constant := 4;   --  EINTR
   Try_Again   : constant := 11;  --  EAGAIN

   Level_Socket : constant := 1;  --  SOL_SOCKET
   Level_Tcp    : constant := 6;  --  IPPROTO_TCP

   subtype Outcome is Integer range -1 .. Integer'Last;
   --  Number of characters; -1 if the call failed

   procedure Receive
     (From  : Socket;
      Flags : int;
      Data  : in out String;
      Got   : out Outcome;
      Error : out Integer)
   with
     Global => (In_Out => Kernel),
     Post   => Got <= Data'Length;

   procedure Send
     (To    : Socket;
      Flags : int;
      Data  : String;
      Put   : out Outcome;
      Error : out Integer)
   with
     Global => (In_Out => Kernel),
     Post   => Put <= Data'Length;

   procedure Set_Number (S : Socket; Level, Name, Value : int)
   with Global => (In_Out => Kernel);
   --  Sets an option. A kernel without it keeps its default

   procedure Get_Error (S : Socket; Error : out Integer)
   with Global => (In_Out => Kernel);
   --  The error of the socket, and clears it. 0 if there is none

   procedure Get_Info
     (S : Socket; Info : out Monitor.Link.Tcp_Info; Filled : out Natural)
   with Global => (In_Out => Kernel);
   --  Filled: the bytes of Info that are known, 0 if the call failed

   --  Values of Events and Returned (poll.h)
   Poll_In          : constant := 16#0001#;
   Poll_Error       : constant := 16#0008#;
   Poll_Hang_Up     : constant := 16#0010#;
   Poll_Peer_Closed : constant := 16#2000#;

   type Watch is record
      Descriptor : int                    := -1;  --  -1: none
      Events     : Interfaces.Unsigned_16 := Poll_In;
      Returned   : Interfaces.Unsigned_16 := 0;
   end record
   with Convention => C;
   --  struct pollfd

   type Watch_Array is array (Positive range <>) of Watch with Convention => C;

   procedure Poll (Entries : in out Watch_Array; Wait_Ms : int)
   with Global => (In_Out => Kernel);
   --  Waits at most Wait_Ms for one of the events; -1: without a limit. May
   --  return early

   procedure Shut_Down (S : Socket; How : int)
   with Global => (In_Out => Kernel);

   procedure Close (S : Socket)
   with Global => (In_Out => Kernel);

end Monitor.Sockets.Stream_Calls;
