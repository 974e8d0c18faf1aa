--  SPDX-License-Identifier: GPL-3.0-or-later
--  The bare C program that forwards from a connection to a line and back:
--  the floor of orders and answers.

with Both_Ends;
with Child_Processes;

package Forwarders is

   procedure Start
     (Process : in out Child_Processes.Child;
      Where   : Both_Ends.Place);
   --  At that place, whose line is open, and connects its other end. At the
   --  priority of the supervisor's task that writes to the line

end Forwarders;
