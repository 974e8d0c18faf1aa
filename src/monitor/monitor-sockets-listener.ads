--  SPDX-License-Identifier: GPL-3.0-or-later
--  The listening socket of the server, and its next connection.

with Networks;
with Options;
with Texts;

package Monitor.Sockets.Listener with
  SPARK_Mode,
  Abstract_State =>
    (Kernel with Synchronous, External => (Async_Readers, Async_Writers)),
  Initializes => Kernel
is

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

end Monitor.Sockets.Listener;
