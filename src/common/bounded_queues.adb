--  SPDX-License-Identifier: GPL-3.0-or-later

package body Bounded_Queues with SPARK_Mode is

   procedure Clear (Q : in out Queue) is
   begin
      Q.Length := 0;
   end Clear;

   procedure Put (Q : in out Queue; Item : Element) is
   begin
      if Q.Length < Capacity then
         Q.Items (Index (Q.First, Q.Length + 1)) := Item;
         Q.Length := Q.Length + 1;
      end if;
   end Put;

   procedure Put_Over_Oldest (Q : in out Queue; Item : Element) is
   begin
      if Is_Full (Q) then
         Remove_First (Q);
      end if;
      Put (Q, Item);
   end Put_Over_Oldest;

   procedure Remove_First (Q : in out Queue) is
   begin
      Q.First := (if Q.First = Capacity then 1 else Q.First + 1);
      Q.Length := Q.Length - 1;
   end Remove_First;

   procedure Replace (Q : in out Queue; I : Place; Item : Element) is
   begin
      Q.Items (Index (Q.First, I)) := Item;
   end Replace;

   procedure Take (Q : in out Queue; Item : out Element; Found : out Boolean)
   is
   begin
      Item := Q.Items (Q.First);
      Found := Q.Length > 0;
      if Found then
         Remove_First (Q);
      end if;
   end Take;

end Bounded_Queues;
