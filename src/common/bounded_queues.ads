--  SPDX-License-Identifier: GPL-3.0-or-later
--  Bounded FIFO queues: no element is lost while the queue is not full, and
--  the length never exceeds the capacity.

generic
   type Element is private;
   Capacity : Positive;
package Bounded_Queues with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Bounded_Queues);  --  proved

   subtype Count is Natural range 0 .. Capacity;

   subtype Place is Positive range 1 .. Capacity;

   type Queue is private;
   --  Initially empty

   function Length (Q : Queue) return Count;

   function Is_Full (Q : Queue) return Boolean is (Length (Q) = Capacity);

   function Element_At (Q : Queue; I : Place) return Element
   with Pre => I <= Length (Q);
   --  The elements of Q: the one at 1 is taken first

   --  Used in the contracts

   function Is_Same (Q, Before : Queue) return Boolean is
     (Length (Q) = Length (Before)
      and then (for all I in 1 .. Length (Q) =>
                  Element_At (Q, I) = Element_At (Before, I)))
   with Ghost;

   function Begins_With (Q, Before : Queue) return Boolean is
     (Length (Q) >= Length (Before)
      and then (for all I in 1 .. Length (Before) =>
                  Element_At (Q, I) = Element_At (Before, I)))
   with Ghost;
   --  The elements of Before are in Q at the same places; Q may have more

   function Is_Without_First (Q, Before : Queue) return Boolean is
     (Length (Before) > 0
      and then Length (Q) = Length (Before) - 1
      and then (for all I in 1 .. Length (Q) =>
                  Element_At (Q, I) = Element_At (Before, I + 1)))
   with Ghost;
   --  Q is Before without its first element

   procedure Clear (Q : in out Queue)
   with Post => Length (Q) = 0;

   procedure Put (Q : in out Queue; Item : Element)
   with
     Post =>
       (if Is_Full (Q'Old) then Is_Same (Q, Q'Old)
        else Begins_With (Q, Q'Old)
          and then Length (Q) = Length (Q'Old) + 1
          and then Element_At (Q, Length (Q)) = Item);
   --  Item becomes the last element. A full queue does not change

   procedure Take (Q : in out Queue; Item : out Element; Found : out Boolean)
   with
     Post => Found = (Length (Q'Old) > 0)
       and then
         (if Found then
             Item = Element_At (Q'Old, 1)
             and then Is_Without_First (Q, Q'Old)
          else Length (Q) = 0);
   --  Removes the first element. Item is undefined if not Found

   procedure Remove_First (Q : in out Queue)
   with
     Pre  => Length (Q) > 0,
     Post => Is_Without_First (Q, Q'Old);

   procedure Put_Over_Oldest (Q : in out Queue; Item : Element)
   with
     Post => Length (Q) = Count'Min (Capacity - 1, Length (Q'Old)) + 1
       and then Element_At (Q, Length (Q)) = Item
       and then
         (for all I in 1 .. Length (Q) - 1 =>
            Element_At (Q, I) =
              Element_At (Q'Old, (if Is_Full (Q'Old) then I + 1 else I)));
   --  Item becomes the last element; a full queue drops its first one

   procedure Replace (Q : in out Queue; I : Place; Item : Element)
   with
     Pre  => I <= Length (Q),
     Post => Length (Q) = Length (Q'Old)
       and then Element_At (Q, I) = Item
       and then (for all J in 1 .. Length (Q) =>
                   (if J /= I then
                       Element_At (Q, J) = Element_At (Q'Old, J)));
   --  Replaces the element at I by Item

private

   type Element_Array is array (Place) of Element;

   type Queue is record
      Items  : Element_Array;
      First  : Place := 1;
      Length : Count := 0;
   end record;
   --  A ring buffer: element I is Items (Index (First, I))

   function Index (First, I : Place) return Place is
     (if I - 1 <= Capacity - First then First + (I - 1)
      else I - 1 - (Capacity - First));

   function Length (Q : Queue) return Count is (Q.Length);

   function Element_At (Q : Queue; I : Place) return Element is
     (Q.Items (Index (Q.First, I)));

end Bounded_Queues;
