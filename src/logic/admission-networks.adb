--  SPDX-License-Identifier: GPL-3.0-or-later

package body Admission.Networks with SPARK_Mode is

   procedure Add (L : in out List; N : Network) is
   begin
      L.Count := L.Count + 1;
      L.Items (L.Count) := N;
   end Add;

   function Digits_End (Text : String; First : Positive) return Text_Place
   is
      Result : Text_Place := First - 1;
   begin
      for I in First .. Text'Last loop
         exit when Text (I) not in '0' .. '9';
         Result := I;
         pragma Loop_Invariant (Result = I);
         pragma Loop_Invariant
           (for all J in First .. I => Text (J) in '0' .. '9');
      end loop;
      return Result;
   end Digits_End;

   function Ends (Text : String) return Octet_Ends is
      Result : Octet_Ends := (others => 0);
   begin
      Result (1) := Digits_End (Text, 1);
      for I in 2 .. 4 loop
         Result (I) :=
           (if Result (I - 1) < Text'Last
            then Digits_End (Text, Result (I - 1) + 2)
            else Result (I - 1));
         pragma Loop_Invariant (Result (1) = Digits_End (Text, 1));
         pragma Loop_Invariant
           (for all J in 2 .. I =>
              Result (J) =
                (if Result (J - 1) < Text'Last
                 then Digits_End (Text, Result (J - 1) + 2)
                 else Result (J - 1)));
      end loop;
      return Result;
   end Ends;

   procedure Parse (Text : String; N : out Network; V : out Verdict) is
   begin
      N := (others => <>);
      if not Begins_With_Address (Text) then
         V := No_Address;
         return;
      end if;
      N := (Start => Address_Of (Text), Length => 32);
      if Ends (Text) (4) < Text'Last then
         if not Has_Length (Text) then
            V := No_Address;
            return;
         end if;
         if not Is_Length (Text, Ends (Text) (4) + 2, Text'Last) then
            V := No_Length;
            return;
         end if;
         N.Length := Number (Text, Ends (Text) (4) + 2, Text'Last);
      end if;
      V := (if Is_Network (N) then Good else Not_Clean);
   end Parse;

end Admission.Networks;
