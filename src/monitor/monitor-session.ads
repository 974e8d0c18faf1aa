--  SPDX-License-Identifier: GPL-3.0-or-later
--  The session with the monitor: its stage, whether the supervisor is
--  stopping, and the events between the tasks involved.

with Event;
with Schedule;

package Monitor.Session with SPARK_Mode is

   type Stage_Kind is
     (Free,       --  no monitor: the next one is admitted
      Active,     --  a monitor is in command
      Closing);   --  it is lost: robot, camera and queues are reset

   type Status is record
      Stage    : Stage_Kind := Free;
      Stopping : Boolean    := False;
   end record;

   function May_Follow (S : Status; To : Stage_Kind) return Boolean is
     (case To is
         when Free    => S.Stage = Closing,
         when Active  => S.Stage = Free and then not S.Stopping,
         when Closing => S.Stage = Active);

   protected State with Priority => Schedule.Session_Ceiling is

      procedure Get (Value : out Status);

      procedure Begin_Active (Admitted : out Boolean);
      --  Refused if it may not follow

      procedure Go_On (To : Stage_Kind)
      with Pre => To /= Active;
      --  No effect if it may not follow

      procedure Stop;
      --  The supervisor is stopping: no further monitor is admitted, and the
      --  one in command counts as lost

   private
      Current : Status;
   end State;

   --  The events, each with the task that waits for it

   package Server_Allowed is new Event (Schedule.Th_Server);
   --  The process is set up: trace, processor, memory, log level

   package Listening is new Event (Schedule.Main);

   package Receive_Begins is new Event (Schedule.Th_Receive_From_Mon);
   --  A session begins

   package Watch_Begins is new Event (Schedule.Th_Com_Mon_Perdue);
   --  A session begins

   package Receive_Ended is new Event (Schedule.Th_Com_Mon_Perdue);
   --  Th_receiveFromMon has left the connection

end Monitor.Session;
