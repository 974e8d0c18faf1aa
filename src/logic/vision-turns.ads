--  SPDX-License-Identifier: GPL-3.0-or-later
--  The orders to the vision, carried out one at a time, first in first out.

with Order_Queues;
with Orders;

package Vision.Turns with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Vision.Turns);

   use type Orders.Order;

   type State is private;
   --  Initially no order is carried out and none waits

   function Is_Busy (S : State) return Boolean;
   --  An order is being carried out

   function Waiting (S : State) return Order_Queues.Queue
   with Ghost;

   procedure Put (S : in out State; Item : Orders.Order; Now : out Boolean)
   with
     Post => Now = not Is_Busy (S'Old)
       and then Is_Busy (S)
       and then
         (if Now or else Order_Queues.Is_Full (Waiting (S'Old)) then
             Order_Queues.Is_Same (Waiting (S), Waiting (S'Old))
          else Order_Queues.Begins_With (Waiting (S), Waiting (S'Old))
            and then Order_Queues.Length (Waiting (S)) =
              Order_Queues.Length (Waiting (S'Old)) + 1
            and then Order_Queues.Element_At
              (Waiting (S), Order_Queues.Length (Waiting (S))) = Item);
   --  Now: Item may be carried out at once; otherwise it is queued

   procedure Next
     (S : in out State; Item : out Orders.Order; Found : out Boolean)
   with
     Post => Found = (Order_Queues.Length (Waiting (S'Old)) > 0)
       and then
         (if Found then
             Item = Order_Queues.Element_At (Waiting (S'Old), 1)
             and then Order_Queues.Is_Without_First
               (Waiting (S), Waiting (S'Old))
             and then Is_Busy (S) = Is_Busy (S'Old)
          else Order_Queues.Length (Waiting (S)) = 0
            and then not Is_Busy (S));
   --  The current order has been carried out; takes the next, if any

   procedure Clear (S : in out State)
   with
     Post => Order_Queues.Length (Waiting (S)) = 0
       and then Is_Busy (S) = Is_Busy (S'Old);
   --  Removes those that wait, not the current one

private

   type State is record
      Items : Order_Queues.Queue;
      Busy  : Boolean := False;
   end record;

   function Is_Busy (S : State) return Boolean is (S.Busy);

   function Waiting (S : State) return Order_Queues.Queue is (S.Items);

end Vision.Turns;
