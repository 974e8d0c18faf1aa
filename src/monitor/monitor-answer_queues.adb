--  SPDX-License-Identifier: GPL-3.0-or-later

with Interfaces; use Interfaces;

package body Monitor.Answer_Queues with SPARK_Mode is

   procedure Clear (Q : in out Queue) is
   begin
      Q.First := Next_Number (Q);
      Answers.Clear (Q.Items);
   end Clear;

   procedure Prove_Sum (Count : Natural)
   with
     Ghost,
     Pre  => Count < Orders.Capacity,
     Post => Orders.Ticket (Count + 1) = Orders.Ticket (Count) + 1
   is
      --  Numbers and lengths count alike: by way of 16 bits, which are easier
      --  for the provers than 64
   begin
      pragma Assert (Unsigned_16 (Count + 1) = Unsigned_16 (Count) + 1);
      pragma Assert
        (Orders.Ticket (Count + 1)
         = Orders.Ticket (Unsigned_16 (Count)) + 1);
   end Prove_Sum;

   procedure Put (Q : in out Queue; Number : Orders.Ticket; Item : Answer) is
   begin
      if Is_Awaited (Q, Number) then
         Answers.Replace (Q.Items, Place_Of (Q, Number), Item);
      end if;
   end Put;

   procedure Remove_First (Q : in out Queue) is
   begin
      Prove_Sum (Length (Q) - 1);
      Answers.Remove_First (Q.Items);
      Q.First := Q.First + 1;
   end Remove_First;

   procedure Reserve (Q : in out Queue) is
   begin
      Prove_Sum (Length (Q));
      Answers.Put (Q.Items, (others => <>));
   end Reserve;

   procedure Skip_Nothing (Q : in out Queue) is
      Before : constant Queue := Q with Ghost;
   begin
      while Length (Q) > 0 and then First_Answer (Q).State = Ready_Nothing
      loop
         Remove_First (Q);
         pragma Loop_Variant (Decreases => Length (Q));
         pragma Loop_Invariant (Length (Q) < Length (Before));
         pragma Loop_Invariant (Next_Number (Q) = Next_Number (Before));
         pragma Loop_Invariant
           (for all I in 1 .. Length (Before) - Length (Q) =>
              Answers.Element_At (Places (Before), I).State = Ready_Nothing);
         pragma Loop_Invariant
           (for all I in 1 .. Length (Q) =>
              Answers.Element_At (Places (Q), I) =
                Answers.Element_At
                  (Places (Before), I + (Length (Before) - Length (Q))));
      end loop;
   end Skip_Nothing;

end Monitor.Answer_Queues;
