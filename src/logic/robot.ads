--  SPDX-License-Identifier: GPL-3.0-or-later
--  The robot: what goes over its line, the session with it, and the requests
--  that wait for the line; and, in the rooms above, the line itself and the
--  tasks that use it. Each is a child.

package Robot with SPARK_Mode, Pure is

end Robot;
