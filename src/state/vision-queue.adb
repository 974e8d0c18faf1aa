--  SPDX-License-Identifier: GPL-3.0-or-later

with Schedule;
with Vision.Turns;

package body Vision.Queue with SPARK_Mode is

   protected Queue with Priority => Schedule.Turn_Ceiling is
      procedure Put (Item : Orders.Order; Now : out Boolean);
      procedure Next (Item : out Orders.Order; Found : out Boolean);
      procedure Clear;
   private
      Turns : Vision.Turns.State;
   end Queue;

   protected body Queue is

      procedure Put (Item : Orders.Order; Now : out Boolean) is
      begin
         Vision.Turns.Put (Turns, Item, Now);
      end Put;

      procedure Next (Item : out Orders.Order; Found : out Boolean) is
      begin
         Vision.Turns.Next (Turns, Item, Found);
      end Next;

      procedure Clear is
      begin
         Vision.Turns.Clear (Turns);
      end Clear;

   end Queue;

   procedure Put (Item : in out Orders.Order) is
      Now : Boolean;
   begin
      Queue.Put (Item, Now);
      Item.Owed := Now;
   end Put;

   procedure Next (Item : out Orders.Order) is
      Found : Boolean;
   begin
      Queue.Next (Item, Found);
      Item.Owed := Found;
   end Next;

   procedure Clear is
   begin
      Queue.Clear;
   end Clear;

end Vision.Queue;
