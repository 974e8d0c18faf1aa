--  SPDX-License-Identifier: GPL-3.0-or-later
--  Admission of the monitor: the token and its file, and pending connections.

package Admission with SPARK_Mode, Pure is

end Admission;
