--  SPDX-License-Identifier: GPL-3.0-or-later
--  The monitor: its protocol, what waits to be sent, the connection, the
--  session of the monitor in command, and the tasks that serve it.

package Monitor with SPARK_Mode, Pure is

end Monitor;
