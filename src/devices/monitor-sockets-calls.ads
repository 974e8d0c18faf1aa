--  SPDX-License-Identifier: GPL-3.0-or-later
--  C library functions shared by gate and connection, with constants of the
--  Linux kernel's interface.

with Interfaces;   use Interfaces;
with Interfaces.C; use Interfaces.C;
with Linux;        use Linux;
with System;

private package Monitor.Sockets.Calls with SPARK_Mode => Off is
   --  Off: addresses are passed to C

   Level_Tcp    : constant := 6;   --  IPPROTO_TCP
   Level_Socket : constant := 1;   --  SOL_SOCKET
   Info_Option  : constant := 11;  --  TCP_INFO

   function C_Send
     (To : Socket; Data : System.Address; Length : size_t; Flags : int)
      return Ssize
   with Import, Convention => C, External_Name => "send";

   function C_Receive
     (From : Socket; Data : System.Address; Length : size_t; Flags : int)
      return Ssize
   with Import, Convention => C, External_Name => "recv";

   procedure C_Shutdown (S : Socket; How : int)
   with Import, Convention => C, External_Name => "shutdown";

   function Get_Option
     (S : Socket; Level, Name : int; Value, Size : System.Address) return int
   with Import, Convention => C, External_Name => "getsockopt";

   procedure Set_Option
     (S : Socket; Level, Name : int; Value : System.Address; Size : unsigned)
   with Import, Convention => C, External_Name => "setsockopt";
   --  A kernel without the option keeps its default

   --  The beginning of the kernel's struct tcp_info (linux/tcp.h)
   type Word_Array is array (Positive range <>) of Unsigned_32
     with Convention => C;

   type Tcp_Info is record
      States      : Word_Array (1 .. 6);   --  states, times, segment sizes
      Unacked     : Unsigned_32;           --  segments; for a listening socket
      Selected    : Unsigned_32;           --  its queue's length and limit
      Counters    : Word_Array (1 .. 5);   --  up to the last one sent
      Last_Data   : Unsigned_32;           --  ms since data was received
      Last_Ack    : Unsigned_32;           --  ms since an ack was received
      Metrics     : Word_Array (1 .. 11);
      Pacing      : Word_Array (1 .. 4);
      Bytes_Acked : Unsigned_64;
      Bytes_Got   : Unsigned_64;
      Segments    : Word_Array (1 .. 2);
      Not_Sent    : Unsigned_32;           --  bytes
      Shortest    : Unsigned_32;
   end record with Convention => C, Size => 152 * 8;

end Monitor.Sockets.Calls;
