--  SPDX-License-Identifier: GPL-3.0-or-later
--  The pending connections, which are to be admitted or rejected.

with Event_Counters;

package Monitor.Sockets.Gate with
  SPARK_Mode,
  Abstract_State =>
    (Waiting with Synchronous, External => (Async_Readers, Async_Writers)),
  Initializes => (Waiting => Event_Counters.Kernel)
is

   subtype Place is Positive range 1 .. 9;
   --  Of a connection: eight that are pending, and the one that comes

   type Socket_Array is array (Place) of Socket;

   procedure Wait (Watched : Socket_Array; Pending : Boolean);
   --  Waits for input from one of the sockets Watched, or its end, for a
   --  connection in the kernel's queue, or for Wake_Server; Pending: at most
   --  for Schedule.Pending_Period. May return early

   procedure Wake_Server;

   procedure Read_Line
     (From   : Socket;
      Data   : in out String;
      Length : out Natural;
      Open   : out Boolean)
   with
     Pre  => Data'First > 0,
     Post => Length <= Data'Length;
   --  What the peer has sent, up to the first line feed: what follows is left
   --  for the session. Never waits. Not Open: the peer has closed

   procedure Refuse (Refused : Socket; Message : String);
   --  Sends Message to the client and closes its connection; never waits

end Monitor.Sockets.Gate;
