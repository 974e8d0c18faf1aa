--  SPDX-License-Identifier: GPL-3.0-or-later
--  A mission's picture: the planned path and the robot's trail over the
--  arena.

with Emulators;
with Mission_Judges; use Mission_Judges;
with Mission_Plans;  use Mission_Plans;

package Mission_Pictures is

   procedure Read_Journal (Path : String; Notes : out Emulators.Notes);
   --  The lines of the journal among those that an emulator has printed

   procedure Draw
     (P     : Plan;
      Notes : Emulators.Notes;
      Path  : String;
      V     : out Verdict)
     with Pre => P.Count > 0;
   --  As an SVG file, with what the journal says of the trail. V is judged as
   --  if it was said to be done

end Mission_Pictures;
