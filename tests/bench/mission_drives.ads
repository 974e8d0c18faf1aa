--  SPDX-License-Identifier: GPL-3.0-or-later
--  The load beside missions that the analysis of the deadlines takes for
--  granted.

with Rigs;

package Mission_Drives is

   Emulator_Options : constant String := "--baud 9600 --camera-fps 30";
   --  As the analysis has line and camera

   procedure Prepare (R : in out Rigs.Rig);
   --  All that a mission needs, of a monitor that is connected

   type Tally is record
      Missions  : Natural := 0;
      Otherwise : Natural := 0;
      --  that did not begin, or ended otherwise than meant
   end record;

   procedure Drive
     (R : in out Rigs.Rig; For_Time : Duration; Count : out Tally);
   --  Missions through random points, one after the other; questions of the
   --  monitor meanwhile, one of them for another mission, of as many points as
   --  there may be. Every third mission is ended by hand. The last one ends
   --  after For_Time

   procedure Report (Count : Tally);

   procedure Measure_Tasks;
   --  For Task_Times, with two busy loops

end Mission_Drives;
