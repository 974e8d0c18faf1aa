--  SPDX-License-Identifier: GPL-3.0-or-later
--  The four monitor tasks of the design report.

with Schedule;

package Monitor.Tasks with SPARK_Mode is

   pragma Elaborate_Body;

   task Th_Server with Priority => Schedule.Server_Priority;
   --  Starts the server (F1), admits the monitor (F2), closes its session

   task Th_Receive_From_Mon with Priority => Schedule.Receive_Priority;
   --  Receives, decodes and dispatches all messages (F3)

   task Th_Send_To_Mon with Priority => Schedule.Send_Priority;
   --  Sends the messages in the outbox (F4)

   task Th_Com_Mon_Perdue with Priority => Schedule.Lost_Priority;
   --  Detects the loss of the monitor (F5) and resets everything to the
   --  initial state (F6)

end Monitor.Tasks;
