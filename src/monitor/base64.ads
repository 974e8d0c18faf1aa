--  SPDX-License-Identifier: GPL-3.0-or-later
--  Base64 with padding and without line breaks (RFC 4648, section 4): images
--  as they are sent to the monitor.

with Bytes; use Bytes;

package Base64 with SPARK_Mode is

   Max_Input : constant := 2 ** 28;
   --  Bytes per encoding; keeps every length within Natural.

   subtype Input_Length is Natural range 0 .. Max_Input;

   function Encoded_Length (Length : Input_Length) return Natural is
     ((Length + 2) / 3 * 4);
   --  Characters: four for each group of three bytes.

   Alphabet : constant array (0 .. 63) of Character :=
     "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
   Padding  : constant Character := '=';

   function Bits
     (Input : Byte_Array; Length : Input_Length; I : Positive) return Natural
   is (if I <= Length then Natural (Input (I)) else 0)
   with
     Pre  => Input'First = 1 and then Length <= Input'Last,
     Post => Bits'Result <= 255;
   --  Byte I of the input, 0 behind its end.

   function Encoded_At
     (Input : Byte_Array; Length : Input_Length; K, J : Natural)
      return Character
   is (case J is
          when 0 => Alphabet (Bits (Input, Length, 3 * K + 1) / 4),
          when 1 => Alphabet (Bits (Input, Length, 3 * K + 1) mod 4 * 16
                              + Bits (Input, Length, 3 * K + 2) / 16),
          when 2 =>
            (if 3 * K + 2 > Length then Padding
             else Alphabet (Bits (Input, Length, 3 * K + 2) mod 16 * 4
                            + Bits (Input, Length, 3 * K + 3) / 64)),
          when others =>
            (if 3 * K + 3 > Length then Padding
             else Alphabet (Bits (Input, Length, 3 * K + 3) mod 64)))
   with
     Pre => Input'First = 1 and then Length <= Input'Last
       and then K < Encoded_Length (Length) / 4 and then J <= 3;
   --  Character J of group K, both from 0, of the encoding of
   --  Input (1 .. Length).

   procedure Encode
     (Input  : Byte_Array;
      Length : Input_Length;
      Output : in out String;
      First  : Positive;
      Last   : out Natural)
   with
     Pre  => Input'First = 1 and then Length <= Input'Last
       and then First >= Output'First and then First - 1 <= Output'Last
       and then Encoded_Length (Length) <= Output'Last - (First - 1),
     Post => Last = First - 1 + Encoded_Length (Length)
       and then
         (for all K in 0 .. Encoded_Length (Length) / 4 - 1 =>
            (for all J in 0 .. 3 =>
               Output (First + 4 * K + J) = Encoded_At (Input, Length, K, J)));
   --  Writes the encoding of the first Length bytes of Input into Output,
   --  from First to Last; First - 1 is Last where there is nothing to write.

end Base64;
