--  SPDX-License-Identifier: GPL-3.0-or-later
--  The listening socket and its next connection.

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

   procedure Take_In
     (Server : Socket;
      Found  : out Socket;
      From   : out Admission.Networks.Socket_Address;
      Name   : out Texts.Text)
   with Global => (In_Out => Kernel);
   --  As Gate.Take_In

end Monitor.Sockets.Gate.Listener_Calls;
