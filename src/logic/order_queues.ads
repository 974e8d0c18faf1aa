--  SPDX-License-Identifier: GPL-3.0-or-later
--  Queues of orders: as many as commands may be waiting for their answers.

pragma SPARK_Mode;

with Bounded_Queues;
with Orders;

package Order_Queues is new Bounded_Queues (Orders.Order, Orders.Capacity);
