--  SPDX-License-Identifier: GPL-3.0-or-later
--  The session with the monitor: who is in command, how a session begins and
--  ends, and the events between the tasks involved.

with Monitor.Session_Stages;

package Monitor.Session with SPARK_Mode is

   procedure Get (Current : out Monitor.Session_Stages.State)
   with Annotate => (GNATprove, Terminating);

   procedure Begin_Active (Admitted : out Boolean)
   with Annotate => (GNATprove, Terminating);
   --  Refused if the supervisor is stopping, or a session has not ended
   procedure Begin_Closing with Annotate => (GNATprove, Terminating);
   procedure End_Closing with Annotate => (GNATprove, Terminating);
   procedure End_Closed with Annotate => (GNATprove, Terminating);
   --  The four steps of a session; no effect if it is not the next step

   procedure Begin_Work;
   --  The connection is admitted: releases the session's tasks

   procedure Request_Stop with Annotate => (GNATprove, Terminating);
   --  The supervisor is stopping: no further monitor is admitted, and the one
   --  in command counts as lost

   --  The events, each for one task

   procedure Allow_Server with Annotate => (GNATprove, Terminating);
   --  The process is set up: trace, processor, memory, log level
   procedure Wait_Server;
   --  For th_server only

   procedure Server_Listens with Annotate => (GNATprove, Terminating);
   procedure Wait_Listening;
   --  For the main procedure only

   procedure Wait_Receive;
   --  Until a session begins. For th_receiveFromMon only
   procedure Receiver_Left with Annotate => (GNATprove, Terminating);
   procedure Wait_Receiver_Left;
   --  For th_comMonPerdue only

   procedure Wait_Watch;
   --  Until a session begins. For th_comMonPerdue only

end Monitor.Session;
