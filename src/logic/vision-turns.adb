--  SPDX-License-Identifier: GPL-3.0-or-later

package body Vision.Turns with SPARK_Mode is

   procedure Clear (S : in out State) is
   begin
      Order_Queues.Clear (S.Items);
   end Clear;

   procedure Next
     (S : in out State; Item : out Orders.Order; Found : out Boolean) is
   begin
      Order_Queues.Take (S.Items, Item, Found);
      if not Found then
         S.Busy := False;
      end if;
   end Next;

   procedure Put (S : in out State; Item : Orders.Order; Now : out Boolean) is
   begin
      Now := not S.Busy;
      if Now then
         S.Busy := True;
      else
         Order_Queues.Put (S.Items, Item);
      end if;
   end Put;

end Vision.Turns;
