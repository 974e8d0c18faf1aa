--  SPDX-License-Identifier: GPL-3.0-or-later
--  How long an order takes through the supervisor, and its answer back, beside
--  a program that does nothing but forward.

package Order_Times is

   procedure Report_Orders;
   procedure Report_Answers;
   --  The measurement, which both share, is made once

end Order_Times;
