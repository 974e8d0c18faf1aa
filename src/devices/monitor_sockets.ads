--  SPDX-License-Identifier: GPL-3.0-or-later
--  The TCP server for the monitor: a listening socket, the connection of the
--  monitor in command, and newcomers that are to be admitted or refused.

with Ada.Real_Time;
with Blocklists;
with Monitor_Link;
with Networks;
with Options;
with Pending_Connections;
with Texts;

package Monitor_Sockets with
  SPARK_Mode,
  Abstract_State =>
    (Network with Synchronous, External => (Async_Readers, Async_Writers)),
  Initializes => Network
is

   procedure Listen
     (Address : Texts.Text;
      Port    : Options.Port_Number;
      Bound   : out Options.Port_Number;
      Success : out Boolean;
      Reason  : out Texts.Text)
   with Global => (In_Out => Network);
   --  Bound: the port in use, chosen by the system where Port is 0. Reason
   --  says why where Success is false

   subtype Place is Pending_Connections.Place;
   --  Of a newcomer that has neither been admitted nor refused

   subtype Place_Set is Pending_Connections.Place_Set;

   procedure Wait
     (Watched    : Place_Set;
      Listens    : Boolean;
      Until_Time : Ada.Real_Time.Time;
      Ready      : out Place_Set;
      Queued     : out Boolean;
      Woken      : out Boolean)
   with
     Global => (In_Out => Network, Input => Ada.Real_Time.Clock_Time),
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
      From   : out Networks.Peer_Address;
      Event  : out Arrival;
      Reason : out Texts.Text)
   with Global => (In_Out => Network);
   --  The next connection of the kernel's queue gets the place Where, which
   --  must be free; never waits. From: the newcomer's address. Reason says
   --  why where it Failed

   procedure Get_Name (Where : Place; Peer : out Texts.Text)
   with Global => (In_Out => Network);
   --  Of the newcomer that got this place last: its address and port

   procedure Get_Queue (Length, Limit : out Natural)
   with Global => (In_Out => Network);
   --  How many connections wait in the kernel's queue, and how many can; no
   --  connection where the kernel does not say

   procedure Block (Sources : Blocklists.List)
   with Global => (In_Out => Network);
   --  From now on the kernel takes no notice of connections that begin at
   --  Sources, and of all others: they are tried again after 1 s, then 2 s.
   --  A kernel that cannot do that takes all

   procedure Wake_Server with Global => (In_Out => Network);

   procedure Look
     (Where  : Place;
      Data   : in out String;
      Length : out Natural;
      Open   : out Boolean)
   with
     Global => (In_Out => Network),
     Post   => Length <= Data'Length;
   --  How that begins which the newcomer has sent and nobody has taken yet;
   --  never waits. Open is false, and Length 0, when the connection is over

   procedure Take (Where : Place; Count : Natural)
   with Global => (In_Out => Network);
   --  The first Count characters of that are not wanted again

   procedure Admit (Where : Place) with Global => (In_Out => Network);
   --  The newcomer becomes the monitor in command. There must be none

   procedure Refuse (Where : Place; Message : String)
   with Global => (In_Out => Network);
   --  Sends Message to the newcomer and closes its connection; never waits

   procedure Receive
     (Data : in out String; Length : out Natural; Open : out Boolean)
   with
     Global => (In_Out => Network),
     Post   => Length <= Data'Length;
   --  What the monitor in command has sent; waits for it. Open is false,
   --  and Length 0, when the connection is over

   procedure Send
     (Data : String; Length : Natural; Success : out Boolean)
   with
     Global => (In_Out => Network),
     Pre    => Length <= Data'Length;
   --  Sends the first Length characters in one piece; waits while the
   --  connection takes nothing. Fails when the connection is over

   type Loss_Kind is (None, Closed_By_Peer, Reset_By_Peer, No_Sign_Of_Life);

   procedure Watch (Wait : Ada.Real_Time.Time_Span; Loss : out Loss_Kind)
   with Global => (In_Out => Network);
   --  Waits until the connection is over, for Wait at most, to the ms

   procedure Sample (Link : out Monitor_Link.Sample)
   with
     Global => (In_Out => Network, Input => Ada.Real_Time.Clock_Time);
   --  How the connection does, from the kernel (TCP_INFO); only the time
   --  where it does not say all that is needed

   procedure Leave_To_Kernel with Global => (In_Out => Network);
   --  Without samples: it ends the connection itself, for Watch to see, when
   --  it has probed an idle monitor in vain (keep-alive), or when what was
   --  sent has not been taken, for Monitor_Link.Vanished_After in either case

   procedure Shut_Down with Global => (In_Out => Network);
   --  Ends the connection in both directions; frees whoever waits in
   --  Receive, Send or Watch

   procedure Close with Global => (In_Out => Network);
   --  Closes the connection; nobody may be in Receive, Send or Watch

end Monitor_Sockets;
