--  SPDX-License-Identifier: GPL-3.0-or-later
--  Signals that end the program: SIGINT (control C), SIGTERM.

package Interruptions is

   procedure Await;
   --  Waits for one

end Interruptions;
