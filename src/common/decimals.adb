--  SPDX-License-Identifier: GPL-3.0-or-later

package body Decimals is

   subtype Exponent is Natural range 0 .. Max_Digits - 1;

   function Power (E : Exponent) return Positive is
     (case E is
         when 0 => 1,
         when 1 => 10,
         when 2 => 100,
         when 3 => 1_000,
         when 4 => 10_000,
         when 5 => 100_000,
         when 6 => 1_000_000,
         when 7 => 10_000_000);

   procedure Prove_Next_Digit (N : Number; E : Exponent)
   with
     Ghost,
     Pre  => E > 0,
     Post => N / Power (E) * 10 + N / Power (E - 1) mod 10
               = N / Power (E - 1);
   --  N / Power (E) with one more digit of N is N / Power (E - 1).

   procedure Prove_Longer_Value
     (T : Text; First : Positive; Last : Natural)
   with
     Ghost,
     Pre  => First >= T'First
       and then First < Last
       and then Last <= T'Last
       and then Last - First < Max_Digits
       and then Are_Digits (T, First, Last),
     Post => Value (T, First, Last)
               = Value (T, First, Last - 1) * 10 + Digit_Value (T (Last));
   --  The value of a number with one more digit.

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
            Prove_Next_Digit (N, Count - I + 1);
            Prove_Same_Value (Previous, Into, Start + 1, Start + I - 1);
            Prove_Longer_Value (Into, Start + 1, Start + I);
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

   procedure Prove_Longer_Value
     (T : Text; First : Positive; Last : Natural)
   is null;

   procedure Prove_Next_Digit (N : Number; E : Exponent) is
   begin
      case E is
         when 0 => null;
         when 1 => pragma Assert (N / 10 * 10 + N mod 10 = N);
         when 2 => pragma Assert (N / 100 = N / 10 / 10);
         when 3 => pragma Assert (N / 1_000 = N / 100 / 10);
         when 4 => pragma Assert (N / 10_000 = N / 1_000 / 10);
         when 5 => pragma Assert (N / 100_000 = N / 10_000 / 10);
         when 6 => pragma Assert (N / 1_000_000 = N / 100_000 / 10);
         when 7 => pragma Assert (N / 10_000_000 = N / 1_000_000 / 10);
      end case;
   end Prove_Next_Digit;

   procedure Prove_Same_Value
     (A, B : Text; First : Positive; Last : Natural)
   is null;

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
