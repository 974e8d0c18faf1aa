--  SPDX-License-Identifier: GPL-3.0-or-later
--  The TCP server for the monitor: a listening socket, the connection of the
--  monitor in command, and newcomers that are to be admitted or refused.

with Ada.Real_Time;
with Monitor_Link;
with Networks;
with Options;
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

   subtype Place is Positive range 1 .. 8;
   --  Of a newcomer that has neither been admitted nor refused

   No_Place : constant := 0;

   subtype Place_Choice is Natural range No_Place .. Place'Last;

   type Place_Set is array (Place) of Boolean;

   type Arrival is (Newcomer, Input, Woken, Failed, Nothing);

   procedure Wait_Newcomer
     (Free       : Place_Choice;
      Watched    : Place_Set;
      Until_Time : Ada.Real_Time.Time;
      Event      : out Arrival;
      Where      : out Place;
      From       : out Networks.Peer_Address;
      Peer       : out Texts.Text)
   with
     Global => (In_Out => Network, Input => Ada.Real_Time.Clock_Time),
     Post   =>
       (if Event = Newcomer then Where = Free)
       and then (if Event = Input then Watched (Where));
   --  Waits for a connection, which gets the place Free (while there is
   --  none nobody is taken in), for input or the end of a connection at one
   --  of the places Watched, or until Wake_Server; until Until_Time at most.
   --  From, Peer: the newcomer's address, and as a text with its port;
   --  Peer where Failed: the reason. Nothing may come at any time

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
   --  How the connection does, from the kernel (TCP_INFO)

   procedure Shut_Down with Global => (In_Out => Network);
   --  Ends the connection in both directions; frees whoever waits in
   --  Receive, Send or Watch

   procedure Close with Global => (In_Out => Network);
   --  Closes the connection; nobody may be in Receive, Send or Watch

end Monitor_Sockets;
