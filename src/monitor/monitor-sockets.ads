--  SPDX-License-Identifier: GPL-3.0-or-later
--  The TCP server for the monitor: the gate for new connections, and the
--  connection of the monitor in command.

with Interfaces.C;

package Monitor.Sockets with SPARK_Mode, Pure is

   type Socket is private;

   Nobody : constant Socket;

private

   type Socket is new Interfaces.C.int;
   --  The file descriptor

   Nobody : constant Socket := -1;

end Monitor.Sockets;
