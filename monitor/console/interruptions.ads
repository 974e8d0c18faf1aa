--  SPDX-License-Identifier: GPL-3.0-or-later
--  The request to end that comes as a signal: SIGINT (control C), SIGTERM.

package Interruptions is

   procedure Await;
   --  Returns when one has come

end Interruptions;
