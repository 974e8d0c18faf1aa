--  SPDX-License-Identifier: GPL-3.0-or-later
--  Missions of the real supervisor, with the emulator and its camera in real
--  time, driven by the monitor's protocol.

with Mission_Judges; use Mission_Judges;
with Mission_Plans;  use Mission_Plans;

package Real_Missions is

   procedure Run (P : Plan; V : out Verdict);
   --  From nothing: starts the programs, robot, camera and positions, asks for
   --  the mission and waits for its end. Raises Failed where a mission cannot
   --  even begin, or where the robot truly was is not certain.

end Real_Missions;
