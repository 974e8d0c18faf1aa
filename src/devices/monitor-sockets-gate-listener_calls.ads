--  SPDX-License-Identifier: GPL-3.0-or-later
--  The listening socket, made by GNAT.Sockets, and the next connection: a call
--  of the C library, which returns what it returned.

private package Monitor.Sockets.Gate.Listener_Calls with
  SPARK_Mode,
  Abstract_State =>
    (Kernel with Synchronous,
     Part_Of  => Monitor.Sockets.Gate.Newcomers,
     External => (Async_Readers, Async_Writers)),
  Initializes => Kernel
is

   procedure Listen
     (Address : Texts.Text;
      Port    : Options.Port_Number;
      Backlog : Positive;
      Server  : out Socket;
      Bound   : out Options.Port_Number;
      Reason  : out Texts.Text)
   with Global => (In_Out => Kernel);
   --  Creates a socket that listens, and never blocks. Nobody, with the
   --  Reason, if that fails

   procedure Accept_Next
     (From    : Socket;
      Address : out Admission.Networks.Socket_Address;
      Found   : out Socket;
      Error   : out Integer)
   with Global => (In_Out => Kernel);
   --  Nobody, with the Error (errno), if there is none

   procedure Get_Name
     (From : Admission.Networks.Socket_Address; Peer : out Texts.Text)
   with Global => null;
   --  HOST:PORT, or [HOST]:PORT for IPv6

end Monitor.Sockets.Gate.Listener_Calls;
