--  SPDX-License-Identifier: GPL-3.0-or-later
--  The connection of the monitor in command.

with Ada.Real_Time;
with Monitor.Link;

package Monitor.Sockets.Connection with SPARK_Mode is

   procedure Take_Over (Newcomer : Socket);
   --  Newcomer becomes the monitor in command. There must be none

   procedure Expect_Life;
   --  The monitor in command has announced signs of life

   procedure Receive
     (Data : in out String; Length : out Natural; Open : out Boolean)
   with
     Post => Length <= Data'Length
       and then Open = (Length > 0);
   --  Data received from the monitor in command; waits for it. Open is false,
   --  and Length 0, when the connection has ended

   procedure Send
     (Data    : String;
      Length  : Natural;
      Unsent  : in out Boolean;
      Success : out Boolean)
   with
     Pre  => Unsent
       and then Length <= Data'Length
       and then Data'First = 1
       and then Data'Last >= 4,
     Post => not Unsent;
   --  Sends the first Length characters as a whole; waits while the connection
   --  accepts nothing. Fails when the connection has ended. Unsent marks
   --  a message that is still to be sent

   procedure Watch
     (Wait : Ada.Real_Time.Time_Span; Loss : out Monitor.Link.Cause);
   --  Waits until the connection has ended, at most Wait; resolution 1 ms

   procedure Sample
     (Patience : Monitor.Link.Milliseconds; Link : out Monitor.Link.Sample);
   --  State of the connection from the kernel (TCP_INFO); only the time is
   --  valid if the kernel does not provide all that is needed. Patience: with
   --  a monitor that has not announced signs of life

   procedure Leave_To_Kernel;
   --  For use without samples: the kernel itself ends the connection, which
   --  Watch detects, when keep-alive probes of an idle monitor are unanswered
   --  or data is unacknowledged, both for Monitor.Link.Vanished_After

   procedure Shut_Down;
   --  Ends the connection in both directions; calls waiting in Receive, Send
   --  or Watch return

   procedure Close;
   --  Closes the connection; no task may be in Receive, Send or Watch

end Monitor.Sockets.Connection;
