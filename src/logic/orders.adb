--  SPDX-License-Identifier: GPL-3.0-or-later

package body Orders with SPARK_Mode is

   procedure Give_Rank (R : in out Ranks; Item : in out Order) is
   begin
      if Has_Rank (Item.Command.Name) then
         R.Last := R.Last + 1;
         Item.Rank := R.Last;
         Item.After := R.Change;
         if Changes_Session (Item.Command.Name) then
            R.Change := R.Last;
         end if;
      else
         Item.Rank := 0;
         Item.After :=
           (if Item.Command.Name in Mission_Command then R.Last else 0);
      end if;
   end Give_Rank;

end Orders;
