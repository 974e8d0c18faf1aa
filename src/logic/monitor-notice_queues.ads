--  SPDX-License-Identifier: GPL-3.0-or-later
--  Queues of up to eight text messages to the monitor.

pragma SPARK_Mode;

with Bounded_Queues;
with Monitor.Notices;

package Monitor.Notice_Queues is new Bounded_Queues
  (Monitor.Notices.Notice, 8);
