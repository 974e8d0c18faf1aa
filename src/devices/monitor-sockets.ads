--  SPDX-License-Identifier: GPL-3.0-or-later
--  The TCP server for the monitor: the gate for newcomers, and the connection
--  of the monitor in command.

with Interfaces.C;

package Monitor.Sockets with SPARK_Mode, Pure is

   type Socket is private;
   --  Of a newcomer, which the gate hands over when it admits it

private

   type Socket is new Interfaces.C.int;
   --  The system's descriptor

   Nobody : constant Socket := -1;

end Monitor.Sockets;
