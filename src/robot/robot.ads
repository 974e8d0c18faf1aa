--  SPDX-License-Identifier: GPL-3.0-or-later
--  The robot: its protocol, the session with it, requests that wait for the
--  line, the line itself and the tasks that use it.

package Robot with SPARK_Mode, Pure is

end Robot;
