--  SPDX-License-Identifier: GPL-3.0-or-later

package body Order_Meanings with SPARK_Mode is

   procedure Give_Rank (R : in out Ranks; Order : in out Orders.Order) is
   begin
      if Has_Rank (Order.Message.Kind) then
         R.Last := R.Last + 1;
         Order.Rank := R.Last;
         Order.After := R.Change;
         if Changes_Session (Order.Message) then
            R.Change := R.Last;
         end if;
      else
         Order.Rank := 0;
         Order.After :=
           (if Order.Message.Kind in Mission_Order then R.Last else 0);
      end if;
   end Give_Rank;

end Order_Meanings;
