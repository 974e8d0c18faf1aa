--  SPDX-License-Identifier: GPL-3.0-or-later
--  Queues of texts for the monitor: eight may wait.

pragma SPARK_Mode;

with Bounded_Queues;
with Texts;

package Text_Queues is new Bounded_Queues (Texts.Text, Capacity => 8);
