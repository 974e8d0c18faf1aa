--  SPDX-License-Identifier: GPL-3.0-or-later
--  Who may be told the token: not a program of another user of this machine,
--  which may listen on the supervisor's port while the supervisor does not.

with GNAT.Sockets;

package Peers is

   function Objection (Made : GNAT.Sockets.Socket_Type) return String;
   --  To telling it who is at the other end of this TCP connection; empty:
   --  none. Waits until the connection is accepted, for 5 s. Raises
   --  Socket_Error if it ends meanwhile

end Peers;
