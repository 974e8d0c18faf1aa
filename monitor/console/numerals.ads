--  SPDX-License-Identifier: GPL-3.0-or-later
--  Numbers in plain notation: without the leading blank and exponent of Ada's
--  images.

package Numerals is

   function Image (Value : Integer) return String;

   function Image (Value : Long_Float; Decimals : Natural) return String;

   function Seconds (Span : Duration) return String;
   --  With three decimals, no unit

   function Milliseconds (Span : Duration; Decimals : Natural := 2)
     return String;
   --  No unit

   procedure Read (Text : String; Value : out Duration; OK : out Boolean);
   --  Decimal seconds, 0 or more and at most a day: "5", "0.25"

   procedure Read
     (Text  : String;
      First : Integer;
      Last  : Integer;
      Value : out Integer;
      OK    : out Boolean)
   with
     Pre => First <= Last;
   --  Decimal digits with an optional minus sign, in First .. Last

end Numerals;
