--  SPDX-License-Identifier: GPL-3.0-or-later
--  Queues of orders, with room for all commands that may wait for answers.

pragma SPARK_Mode;

with Bounded_Queues;
with Orders;

package Order_Queues is new Bounded_Queues (Orders.Order, Orders.Capacity);
