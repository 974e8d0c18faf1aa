--  SPDX-License-Identifier: GPL-3.0-or-later
--  The connection of the monitor in command.

with Ada.Real_Time;
with Monitor.Link;

package Monitor.Sockets.Connection with
  SPARK_Mode,
  Abstract_State =>
    (Peer with Synchronous, External => (Async_Readers, Async_Writers)),
  Initializes => Peer
is

   procedure Take_Over (Newcomer : Socket)
   with Global => (In_Out => Peer);
   --  From the gate: it becomes the monitor in command. There must be none

   procedure Receive
     (Data : in out String; Length : out Natural; Open : out Boolean)
   with
     Global => (In_Out => Peer),
     Post   => Length <= Data'Length;
   --  What the monitor in command has sent; waits for it. Open is false,
   --  and Length 0, when the connection is over

   procedure Send
     (Data    : String;
      Length  : Natural;
      Unsent  : in out Boolean;
      Success : out Boolean)
   with
     Global => (In_Out => Peer),
     Pre    => Unsent and then Length <= Data'Length,
     Post   => not Unsent;
   --  Sends the first Length characters in one piece; waits while the
   --  connection takes nothing. Fails when the connection is over. Unsent:
   --  the message, which is sent once

   procedure Watch
     (Wait : Ada.Real_Time.Time_Span; Loss : out Monitor.Link.Loss_Kind)
   with Global => (In_Out => Peer);
   --  Waits until the connection is over, for Wait at most, to the ms

   procedure Sample (Link : out Monitor.Link.Sample)
   with
     Global => (In_Out => Peer, Input => Ada.Real_Time.Clock_Time);
   --  How the connection does, from the kernel (TCP_INFO); only the time
   --  where it does not say all that is needed

   procedure Leave_To_Kernel with Global => (In_Out => Peer);
   --  Without samples: it ends the connection itself, for Watch to see, when
   --  it has probed an idle monitor in vain (keep-alive), or when what was
   --  sent has not been taken, for Monitor.Link.Vanished_After in either case

   procedure Shut_Down with Global => (In_Out => Peer);
   --  Ends the connection in both directions; frees whoever waits in
   --  Receive, Send or Watch

   procedure Close with Global => (In_Out => Peer);
   --  Closes the connection; nobody may be in Receive, Send or Watch

end Monitor.Sockets.Connection;
