--  SPDX-License-Identifier: GPL-3.0-or-later
--  The robot's frames: every command, every argument, every short answer.

package Robot_Protocol_Tests is

   procedure Add_Tests;

end Robot_Protocol_Tests;
