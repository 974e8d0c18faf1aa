--  SPDX-License-Identifier: GPL-3.0-or-later
--  The supervisor's lines with the robot's position.

with Monitor.Notices; use Monitor.Notices;

package Position_Lines is

   procedure Parse (Line : String; P : out Position; OK : out Boolean);
   --  Line is without its end. If it is not as docs/wire.md says, OK is False
   --  and P is Not_Found

end Position_Lines;
