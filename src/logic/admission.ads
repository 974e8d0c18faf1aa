--  SPDX-License-Identifier: GPL-3.0-or-later
--  Admission of the monitor: allowed networks, the token, and pending
--  connections. The layers above add children for the token's file and for
--  th_server's handling of new clients.

package Admission with SPARK_Mode, Pure is

end Admission;
