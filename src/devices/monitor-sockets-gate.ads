--  SPDX-License-Identifier: GPL-3.0-or-later
--  The gate of the server for the monitor: the listening socket, and
--  newcomers that are to be admitted or refused.

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
    (Newcomers with Synchronous, External => (Async_Readers, Async_Writers)),
  Initializes => Newcomers
is

   procedure Listen
     (Address : Texts.Text;
      Port    : Options.Port_Number;
      Bound   : out Options.Port_Number;
      Success : out Boolean;
      Reason  : out Texts.Text)
   with Global => (In_Out => Newcomers);
   --  Bound: the port in use, chosen by the system where Port is 0. Reason
   --  says why where Success is false

   subtype Place is Admission.Pending_Connections.Place;
   --  Of a newcomer that has neither been admitted nor refused

   subtype Place_Set is Admission.Pending_Connections.Place_Set;

   procedure Wait
     (Watched    : Place_Set;
      Listens    : Boolean;
      Until_Time : Ada.Real_Time.Time;
      Ready      : out Place_Set;
      Queued     : out Boolean;
      Woken      : out Boolean)
   with
     Global => (In_Out => Newcomers, Input => Ada.Real_Time.Clock_Time),
     Post   =>
       (for all P in Place => (if Ready (P) then Watched (P)))
       and then (if Queued then Listens);
   --  Waits until there is input, or the end of a connection, at one of the
   --  places Watched, which then are Ready; where it Listens, until a
   --  connection waits in the kernel's queue; until Wake_Server; until
   --  Until_Time at most. Nothing may come at any time

   type Arrival is (Newcomer, Nobody_There, Failed);

   procedure Take_In
     (Where  : Place;
      From   : out Admission.Networks.Peer_Address;
      Event  : out Arrival;
      Reason : out Texts.Text)
   with Global => (In_Out => Newcomers);
   --  The next connection of the kernel's queue gets the place Where, which
   --  must be free; never waits. From: the newcomer's address. Reason says
   --  why where it Failed

   procedure Get_Name (Where : Place; Peer : out Texts.Text)
   with Global => (In_Out => Newcomers);
   --  Of the newcomer that got this place last: its address and port

   procedure Get_Queue (Length, Limit : out Natural)
   with Global => (In_Out => Newcomers);
   --  How many connections wait in the kernel's queue, and how many can; no
   --  connection where the kernel does not say

   procedure Block (Sources : Admission.Blocklists.List)
   with Global => (In_Out => Newcomers);
   --  From now on the kernel takes no notice of connections that begin at
   --  Sources, and of all others: they are tried again after 1 s, then 2 s.
   --  A kernel that cannot do that takes all

   procedure Wake_Server with Global => (In_Out => Newcomers);

   procedure Look
     (Where  : Place;
      Data   : in out String;
      Length : out Natural;
      Open   : out Boolean)
   with
     Global => (In_Out => Newcomers),
     Post   => Length <= Data'Length;
   --  How that begins which the newcomer has sent and nobody has taken yet;
   --  never waits. Open is false, and Length 0, when the connection is over

   procedure Take (Where : Place; Count : Natural)
   with Global => (In_Out => Newcomers);
   --  The first Count characters of that are not wanted again

   procedure Admit (Where : Place)
   with Global => (In_Out => (Newcomers, Connection.Peer));
   --  The newcomer becomes the monitor in command. There must be none

   procedure Refuse (Where : Place; Message : String)
   with Global => (In_Out => Newcomers);
   --  Sends Message to the newcomer and closes its connection; never waits

end Monitor.Sockets.Gate;
