--  SPDX-License-Identifier: GPL-3.0-or-later
--  Decimal numbers of up to eight digits, in character or byte strings: read
--  and written by both protocols.

--  A generic is proved in each instance, in the SPARK mode of the instance.

generic
   type Symbol is (<>);
   --  Characters or bytes: the positions are the ASCII codes, 0 .. 255.
   type Text is array (Positive range <>) of Symbol;
package Decimals is

   pragma Annotate (GNATprove, Terminating, Decimals);  --  proved

   pragma Assertion_Policy (Subprogram_Variant => Ignore);
   --  GNAT 12 does not compile it in a generic unit

   Max_Digits : constant := 8;

   subtype Number is Natural range 0 .. 99_999_999;

   subtype Digit_Count is Positive range 1 .. Max_Digits;

   function Is_Digit (S : Symbol) return Boolean is
     (Symbol'Pos (S) in Character'Pos ('0') .. Character'Pos ('9'));

   function Digit_Value (S : Symbol) return Natural is
     (Symbol'Pos (S) - Character'Pos ('0'))
   with
     Pre  => Is_Digit (S),
     Post => Digit_Value'Result <= 9;

   function Are_Digits
     (T : Text; First : Positive; Last : Natural) return Boolean
   is (for all I in First .. Last => Is_Digit (T (I)))
   with Pre => First >= T'First and then Last <= T'Last;
   --  Also True where Last < First.

   function Is_Numeral
     (T : Text; First : Positive; Last : Natural) return Boolean
   is (First >= T'First
       and then Last in First .. T'Last
       and then Are_Digits (T, First, Last));
   --  Digits stand in First .. Last, one at least.

   function Largest (Count : Digit_Count) return Number is
     (case Count is
         when 1 => 9,
         when 2 => 99,
         when 3 => 999,
         when 4 => 9_999,
         when 5 => 99_999,
         when 6 => 999_999,
         when 7 => 9_999_999,
         when 8 => 99_999_999);
   --  The largest number of Count digits.

   function Value (T : Text; First : Positive; Last : Natural) return Number
   is ((if Last = First then 0 else 10 * Value (T, First, Last - 1))
       + Digit_Value (T (Last)))
   with
     Pre  => Is_Numeral (T, First, Last) and then Last - First < Max_Digits,
     Post => Value'Result <= Largest (Last - First + 1),
     Subprogram_Variant => (Decreases => Last);
   --  The number written in First .. Last, eight digits at most.

   function Saturated_Value
     (T : Text; First : Positive; Last : Natural) return Number
   with
     Pre  => Is_Numeral (T, First, Last),
     Post =>
       --  leading zeros, then at most eight digits: exact
       (if Last - First < Max_Digits then
           Saturated_Value'Result = Value (T, First, Last)
        elsif (for all I in First .. Last - Max_Digits =>
                 Digit_Value (T (I)) = 0)
        then Saturated_Value'Result =
               Value (T, Last - Max_Digits + 1, Last)
        else Saturated_Value'Result = Number'Last);
   --  The same for any number of digits; Number'Last if it is larger.

   procedure Append
     (N     : Number;
      Width : Digit_Count;
      Into  : in out Text;
      Last  : in out Natural)
   with
     Pre  => Into'First = 1
       and then Into'Last in Last .. Integer'Last - 1
       and then Into'Last - Last >= Max_Digits,
     Post => Last in Last'Old + Width .. Last'Old + Max_Digits
       and then Is_Numeral (Into, Last'Old + 1, Last)
       and then Value (Into, Last'Old + 1, Last) = N
       and then (Last - Last'Old = Width
                 or else N > Largest (Last - Last'Old - 1))
       and then (for all I in 1 .. Last'Old => Into (I) = Into'Old (I));
   --  Writes N after Last, padded with zeros to Width digits, and moves Last
   --  to its last digit.

   procedure Prove_Same_Value
     (A, B : Text; First : Positive; Last : Natural)
   with
     Ghost,
     Pre  => Is_Numeral (A, First, Last)
       and then Last - First < Max_Digits
       and then First >= B'First
       and then Last <= B'Last
       and then (for all I in First .. Last => A (I) = B (I)),
     Post => Is_Numeral (B, First, Last)
       and then Value (A, First, Last) = Value (B, First, Last),
     Subprogram_Variant => (Decreases => Last);
   --  The value depends only on the digits of the number.

end Decimals;
