--  SPDX-License-Identifier: GPL-3.0-or-later
--  The monitor: what goes over its connection, and what waits to be sent; and,
--  in the rooms above, the connection itself, the session of the monitor in
--  command and the tasks that serve it. Each is a child.

package Monitor with SPARK_Mode, Pure is

end Monitor;
