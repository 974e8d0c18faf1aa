--  SPDX-License-Identifier: GPL-3.0-or-later
--  Who may be the monitor: the networks that are allowed, the token, and the
--  connections that wait for a decision; and, in the rooms above, the file of
--  the token and the newcomers themselves. Each is a child.

package Admission with SPARK_Mode, Pure is

end Admission;
