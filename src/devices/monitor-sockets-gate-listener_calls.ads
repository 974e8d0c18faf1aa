--  SPDX-License-Identifier: GPL-3.0-or-later
--  The listening socket: made by GNAT.Sockets; for all else a call of the C
--  library each, once, which returns what it returned.

with Admission.Packet_Filters;
with Admission.Socket_Addresses;
with Bytes;
with Interfaces.C; use Interfaces.C;

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
      Address : out Admission.Socket_Addresses.Socket_Address;
      Found   : out Socket;
      Error   : out Integer)
   with Global => (In_Out => Kernel);
   --  Nobody, with the Error (errno), if there is none

   procedure Attach
     (To     : Socket;
      Filter : Admission.Packet_Filters.Program;
      Done   : out Boolean)
   with
     Global => (In_Out => Kernel),
     Pre    => Admission.Packet_Filters.Is_Sound (Filter);
   --  In place of the filter before

   procedure New_Counter (Counter : out int)
   with Global => (In_Out => Kernel);
   --  An event counter whose reads do not block

   procedure Add_One (To : int)
   with Global => (In_Out => Kernel);

   procedure Clear (Counter : int)
   with Global => (In_Out => Kernel);

   procedure Get_Host
     (Family : int;
      Host   : Bytes.Byte_Array;
      Text   : out Admission.Socket_Addresses.Host_Text)
   with
     Global => null,
     Pre    => Host'Length =
       (if Family = Admission.Socket_Addresses.Inet_Family then 4 else 16);
   --  The text of an address, followed by NUL

end Monitor.Sockets.Gate.Listener_Calls;
