--  SPDX-License-Identifier: GPL-3.0-or-later

package body Decimals is

   function Power (E : Natural) return Positive is
     (if E = 0 then 1 else Largest (E) + 1)
   with Pre => E < Max_Digits;

   procedure Append
     (N     : Number;
      Width : Digit_Count;
      Into  : in out Text;
      Last  : in out Natural)
   is
      Start    : constant Natural := Last;
      Before   : constant Text := Into with Ghost;
      Previous : Text := Into with Ghost;
      Count    : Digit_Count := Width;
   begin
      while Count < Max_Digits and then N > Largest (Count) loop
         Count := Count + 1;
         pragma Loop_Invariant
           (Count > Width and then N > Largest (Count - 1));
         pragma Loop_Variant (Increases => Count);
      end loop;

      for I in 1 .. Count loop
         Previous := Into;
         Into (Start + I) :=
           Symbol'Val
             (Character'Pos ('0') + N / Power (Count - I) mod 10);
         pragma Assert (Are_Digits (Into, Start + 1, Start + I));
         if I > 1 then
            pragma Assert
              (N / Power (Count - I + 1) = N / Power (Count - I) / 10);
            Prove_Same_Value (Previous, Into, Start + 1, Start + I - 1);
         end if;
         pragma Loop_Invariant (Are_Digits (Into, Start + 1, Start + I));
         pragma Loop_Invariant
           (Value (Into, Start + 1, Start + I) = N / Power (Count - I));
         pragma Loop_Invariant
           (for all J in Into'Range =>
              (if J <= Start or else J > Start + I then
                  Into (J) = Before (J)));
      end loop;
      Last := Start + Count;
   end Append;

   procedure Prove_Same_Value
     (A, B : Text; First : Positive; Last : Natural) is
   begin
      if Last > First then
         Prove_Same_Value (A, B, First, Last - 1);
      end if;
   end Prove_Same_Value;

   function Saturated_Value
     (T : Text; First : Positive; Last : Natural) return Number
   is
      Start : Positive := First;
   begin
      if Last - First >= Max_Digits then
         Start := Last - Max_Digits + 1;
         for I in First .. Start - 1 loop
            if Digit_Value (T (I)) /= 0 then
               return Number'Last;
            end if;
            pragma Loop_Invariant
              (for all J in First .. I => Digit_Value (T (J)) = 0);
         end loop;
      end if;
      return Value (T, Start, Last);
   end Saturated_Value;

end Decimals;
