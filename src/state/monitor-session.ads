--  SPDX-License-Identifier: GPL-3.0-or-later
--  The session with the monitor: who is in command, how a session begins and
--  ends, and the events between the tasks involved. The object only locks;
--  Monitor.Session_Stages decides.

with Event;
with Monitor.Session_Stages;
with Schedule;

package Monitor.Session with SPARK_Mode is

   use type Monitor.Session_Stages.Stage_Kind;

   protected State with Priority => Schedule.Session_Ceiling is

      procedure Get (Value : out Monitor.Session_Stages.State);

      procedure Begin_Active (Admitted : out Boolean);
      --  Refused if the supervisor is stopping, or a session has not ended

      procedure Go_On (To : Monitor.Session_Stages.Stage_Kind)
      with Pre => To /= Monitor.Session_Stages.Active;
      --  The next stage; no effect if To is not the next

      procedure Stop;
      --  The supervisor is stopping: no further monitor is admitted, and the
      --  one in command counts as lost

   private
      Current : Monitor.Session_Stages.State;
   end State;

   --  The events, each with the task that waits for it

   package Server_Allowed is new Event;
   --  The process is set up: trace, processor, memory, log level. Th_server

   package Listening is new Event;
   --  The main procedure

   package Receive_Begins is new Event;
   --  A session begins. Th_receiveFromMon

   package Watch_Begins is new Event;
   --  A session begins. Th_comMonPerdue

   package Receive_Ended is new Event;
   --  Th_receiveFromMon has left the connection. Th_comMonPerdue

end Monitor.Session;
