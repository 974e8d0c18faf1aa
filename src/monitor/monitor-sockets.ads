--  SPDX-License-Identifier: GPL-3.0-or-later
--  TCP sockets: the listening socket, its next connection, and the calls of
--  the C library for a connection. Each makes one call, once, and returns what
--  it returned.

with Interfaces;
with Interfaces.C; use Interfaces.C;
with Monitor.Link;
with Networks;
with Options;
with Texts;

package Monitor.Sockets with
  SPARK_Mode,
  Abstract_State =>
    (Kernel with Synchronous, External => (Async_Readers, Async_Writers)),
  Initializes => Kernel
is

   type Socket is new int;
   --  The file descriptor

   Nobody : constant Socket := -1;

   --  The server

   procedure Listen
     (Address : Texts.Text;
      Port    : Options.Port_Number;
      Bound   : out Options.Port_Number;
      Success : out Boolean;
      Reason  : out Texts.Text)
   with Global => (In_Out => Kernel);
   --  Bound: the port in use, chosen by the system if Port is 0. Reason
   --  explains a failure

   function Listening return Socket
   with Volatile_Function, Global => (Input => Kernel);
   --  To wait for it with others

   procedure Take_In
     (Found : out Socket;
      From  : out Networks.Host;
      Name  : out Texts.Text)
   with Global => (In_Out => Kernel);
   --  Accepts the next connection of the kernel's queue; never waits. Name:
   --  HOST:PORT, or [HOST]:PORT for IPv6. Nobody: there is none, Name is
   --  empty; or it has failed, and Name says why

   --  A connection

   subtype Outcome is Integer range -Integer'Last .. Integer'Last;
   --  Number of characters, or, if the call failed, its error, negative

   Interrupted : constant := -4;   --  EINTR
   Try_Again   : constant := -11;  --  EAGAIN

   procedure Receive
     (From : Socket; Flags : int; Data : in out String; Got : out Outcome)
   with
     Global => (In_Out => Kernel),
     Post   => Got <= Data'Length;

   procedure Send
     (To : Socket; Flags : int; Data : String; Put : out Outcome)
   with
     Global => (In_Out => Kernel),
     Post   => Put <= Data'Length;

   Level_Socket : constant := 1;  --  SOL_SOCKET
   Level_Tcp    : constant := 6;  --  IPPROTO_TCP

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

end Monitor.Sockets;
