--  SPDX-License-Identifier: GPL-3.0-or-later
--  The listening socket of the server, and the pending connections, which are
--  to be admitted or rejected.

with Ada.Real_Time;
with Admission.Blocklists;
with Admission.Networks;
with Admission.Pending_Connections;
with Monitor.Sockets.Connection;
with Options;
with Texts;

package Monitor.Sockets.Gate with
  SPARK_Mode,
  Abstract_State =>
    (Pending,
     (Newcomers with Synchronous, External => (Async_Readers, Async_Writers))),
  Initializes => (Newcomers, Pending)
is
   --  Newcomers: the sockets in the kernel. Pending: which of them are pending
   --  connections, and their addresses; for one task only

   procedure Listen
     (Address : Texts.Text;
      Port    : Options.Port_Number;
      Bound   : out Options.Port_Number;
      Success : out Boolean;
      Reason  : out Texts.Text)
   with Global => (In_Out => Newcomers);
   --  Bound: the port in use, chosen by the system if Port is 0. Reason
   --  explains a failure

   subtype Place is Admission.Pending_Connections.Place;
   --  Index of a pending connection, neither admitted nor rejected

   subtype Place_Set is Admission.Pending_Connections.Place_Set;

   procedure Wait
     (Watched    : Place_Set;
      Listens    : Boolean;
      Until_Time : Ada.Real_Time.Time;
      Ready      : out Place_Set;
      Queued     : out Boolean;
      Woken      : out Boolean)
   with
     Global => (In_Out => Newcomers,
                Input  => (Pending, Ada.Real_Time.Clock_Time)),
     Post   =>
       (for all P in Place => (if Ready (P) then Watched (P)))
       and then (if Queued then Listens);
   --  Waits until one of the places Watched is Ready (input, or end of
   --  connection); if it Listens, also until a connection waits in the
   --  kernel's queue; until Wake_Server; or until Until_Time. May return early
   --  with nothing ready

   type Arrival is (Newcomer, Nobody_There, Failed);

   procedure Take_In
     (Where  : Place;
      From   : out Admission.Networks.Peer_Address;
      Event  : out Arrival;
      Reason : out Texts.Text)
   with Global => (In_Out => (Newcomers, Pending));
   --  Accepts the next connection of the kernel's queue into the place Where,
   --  which must be free; never waits. From: the peer's address. Reason
   --  explains a failure

   procedure Get_Name (Where : Place; Peer : out Texts.Text)
   with Global => (Input => Pending);
   --  Address and port of the last client at this place

   procedure Get_Queue (Length, Limit : out Natural)
   with Global => (In_Out => Newcomers);
   --  Length and limit of the kernel's queue; Length is 0 if the kernel does
   --  not tell

   procedure Block
     (Sources : Admission.Blocklists.List; Done : out Boolean)
   with Global => (In_Out => Newcomers);
   --  From now on the kernel ignores new connections from Sources, and from no
   --  others. The peers retry after 1 s, then 2 s. Not Done: a kernel without
   --  filters, or that allows them with CAP_NET_ADMIN only, accepts all

   procedure Wake_Server with Global => (In_Out => Newcomers);

   procedure Look
     (Where  : Place;
      Data   : in out String;
      Length : out Natural;
      Open   : out Boolean)
   with
     Global => (In_Out => Newcomers, Input => Pending),
     Post   => Length <= Data'Length
       and then (if not Open then Length = 0);
   --  Reads what the pending connection has sent, without consuming it; never
   --  waits. Open is false and Length 0 if the peer has closed

   procedure Take (Where : Place; Count : Natural)
   with Global => (In_Out => Newcomers, Input => Pending);
   --  Consumes the first Count of these characters

   procedure Admit (Where : Place)
   with Global => (In_Out => (Pending, Connection.Peer));
   --  The client becomes the monitor in command. There must be none

   procedure Refuse (Where : Place; Message : String)
   with Global => (In_Out => (Newcomers, Pending));
   --  Sends Message to the client and closes its connection; never waits

end Monitor.Sockets.Gate;
