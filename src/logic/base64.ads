--  SPDX-License-Identifier: GPL-3.0-or-later
--  Base64 with padding and without line breaks (RFC 4648, section 4): the
--  encoding of images sent to the monitor.

with Bytes; use Bytes; use type Bytes.Byte;

package Base64 with SPARK_Mode is

   Max_Input : constant := 2 ** 28;
   --  Bytes per encoding; keeps every length within Natural.

   subtype Input_Length is Natural range 0 .. Max_Input;

   function Encoded_Length (Length : Input_Length) return Natural is
     ((Length + 2) / 3 * 4);
   --  Length of the encoding of Length bytes: four for each group of three.

   --  Used in the contracts

   subtype Sextet is Natural range 0 .. 63;

   subtype Place is Natural range 0 .. 3;

   function Symbol (Value : Sextet) return Character is
     (if Value < 26 then Character'Val (Character'Pos ('A') + Value)
      elsif Value < 52 then Character'Val (Character'Pos ('a') + Value - 26)
      elsif Value < 62 then Character'Val (Character'Pos ('0') + Value - 52)
      elsif Value = 62 then '+'
      else '/')
   with Ghost;
   --  The alphabet of RFC 4648, table 1.

   Padding : constant Character := '=';

   function Is_Symbol (C : Character) return Boolean is
     (C in 'A' .. 'Z' | 'a' .. 'z' | '0' .. '9' | '+' | '/');

   function Value_Of (C : Character) return Sextet is
     (case C is
         when 'A' .. 'Z' => Character'Pos (C) - Character'Pos ('A'),
         when 'a' .. 'z' => Character'Pos (C) - Character'Pos ('a') + 26,
         when '0' .. '9' => Character'Pos (C) - Character'Pos ('0') + 52,
         when '+'        => 62,
         when '/'        => 63,
         when others     => 0);
   --  The index of C in the alphabet; 0 for other characters.

   function Is_Input (Input : Byte_Array; Length : Natural) return Boolean is
     (Input'First = 1
      and then Length <= Input'Last
      and then Length <= Max_Input)
   with Ghost;

   function Bits (Input : Byte_Array; Length, I : Natural) return Natural is
     (if I in 1 .. Length then Natural (Input (I)) else 0)
   with
     Ghost,
     Pre  => Is_Input (Input, Length),
     Post => Bits'Result <= 255;
   --  Byte I of the input, zero after its end.

   function Group_Character
     (Input : Byte_Array; Length, K : Natural; J : Place) return Character
   with
     Ghost,
     Pre  => Is_Input (Input, Length)
       and then K < Encoded_Length (Length) / 4,
     Post => Group_Character'Result =
       (case J is
           when 0 =>
             Symbol (Bits (Input, Length, 3 * K + 1) / 4),
           when 1 =>
             Symbol (Bits (Input, Length, 3 * K + 1) mod 4 * 16
                     + Bits (Input, Length, 3 * K + 2) / 16),
           when 2 =>
             (if 3 * K + 2 > Length then Padding
              else Symbol (Bits (Input, Length, 3 * K + 2) mod 16 * 4
                           + Bits (Input, Length, 3 * K + 3) / 64)),
           when 3 =>
             (if 3 * K + 3 > Length then Padding
              else Symbol (Bits (Input, Length, 3 * K + 3) mod 64)))
       and then (Is_Symbol (Group_Character'Result)
                 or else Group_Character'Result = Padding)
       and then (Group_Character'Result = Padding) =
                  (J > 1 and then 3 * K + J > Length);
   --  Character J of group K, both counted from 0, of the encoding of
   --  Input (1 .. Length).

   function Encoded_At
     (Input : Byte_Array; Length, P : Natural) return Character
   is (Group_Character (Input, Length, P / 4, P mod 4))
   with
     Ghost,
     Pre => Is_Input (Input, Length) and then P < Encoded_Length (Length);
   --  Character P, counted from 0, of the encoding of Input (1 .. Length).

   function Are_Symbols_At (Text : String; K : Natural) return Boolean
   with
     Ghost,
     Pre  => Text'Last < Integer'Last and then K < Text'Length / 4,
     Post => Are_Symbols_At'Result =
       (Is_Symbol (Text (Text'First + 4 * K))
        and then Is_Symbol (Text (Text'First + 4 * K + 1))
        and then Is_Symbol (Text (Text'First + 4 * K + 2))
        and then Is_Symbol (Text (Text'First + 4 * K + 3)));
   --  Group K, counted from 0, has no padding.

   function Is_Last_Group (C1, C2, C3, C4 : Character) return Boolean is
     (Is_Symbol (C1)
      and then Is_Symbol (C2)
      and then
        (if C4 /= Padding then Is_Symbol (C3) and then Is_Symbol (C4)
         elsif C3 /= Padding then
            Is_Symbol (C3) and then Value_Of (C3) mod 4 = 0
         else Value_Of (C2) mod 16 = 0))
   with Ghost;
   --  The unused bits before the padding are zero.

   function Is_Well_Formed (Text : String) return Boolean is
     (Text'Length mod 4 = 0
      and then
        (for all K in 0 .. Text'Length / 4 - 2 => Are_Symbols_At (Text, K))
      and then
        (if Text'Length > 0 then
            Is_Last_Group (Text (Text'Last - 3), Text (Text'Last - 2),
                           Text (Text'Last - 1), Text (Text'Last))))
   with
     Ghost,
     Pre => Text'Last < Integer'Last;
   --  Text is the encoding of some input.

   function Decoded_Length (Text : String) return Natural is
     (if Text'Length < 4 then 0
      elsif Text (Text'Last) /= Padding then Text'Length / 4 * 3
      elsif Text (Text'Last - 1) /= Padding then Text'Length / 4 * 3 - 1
      else Text'Length / 4 * 3 - 2)
   with
     Ghost,
     Pre => Text'Last < Integer'Last;

   function Decoded_At (Text : String; I : Positive) return Byte
   with
     Ghost,
     Pre  => Text'Last < Integer'Last
       and then I <= Text'Length / 4 * 3,
     Post => Natural (Decoded_At'Result) =
       (case (I - 1) mod 3 is
           when 0 =>
             Value_Of (Text (Text'First + (I - 1) / 3 * 4)) * 4
             + Value_Of (Text (Text'First + (I - 1) / 3 * 4 + 1)) / 16,
           when 1 =>
             Value_Of (Text (Text'First + (I - 1) / 3 * 4 + 1)) mod 16 * 16
             + Value_Of (Text (Text'First + (I - 1) / 3 * 4 + 2)) / 4,
           when others =>
             Value_Of (Text (Text'First + (I - 1) / 3 * 4 + 2)) mod 4 * 64
             + Value_Of (Text (Text'First + (I - 1) / 3 * 4 + 3)));
   --  Byte I of what Text encodes.

   --  The operations

   procedure Encode
     (Input  : Byte_Array;
      Length : Natural;
      Output : in out String;
      First  : Positive;
      Last   : out Natural)
   with
     Pre  => Input'First = 1
       and then Length <= Input'Last
       and then Length <= Max_Input
       and then First >= Output'First
       and then First - 1 <= Output'Last
       and then Encoded_Length (Length) <= Output'Last - (First - 1),
     Post => Last = First - 1 + Encoded_Length (Length)
       and then
         (for all P in 0 .. Encoded_Length (Length) - 1 =>
            Output (First + P) = Encoded_At (Input, Length, P))
       and then
         (for all I in Output'Range =>
            (if I < First or else I > Last then
                Output (I) = Output'Old (I)));
   --  Writes the encoding of the first Length bytes of Input into Output,
   --  from First to Last; First - 1 is Last where there is nothing to
   --  write. The rest of Output stays as it was.

   procedure Decode
     (Input  : String;
      Output : in out Byte_Array;
      Length : out Natural;
      OK     : out Boolean)
   with
     Pre  => Input'Last < Integer'Last
       and then Output'First = 1
       and then Input'Length / 4 * 3 <= Output'Last,
     Post => OK = Is_Well_Formed (Input)
       and then Length = (if OK then Decoded_Length (Input) else 0)
       and then
         (for all I in 1 .. Length => Output (I) = Decoded_At (Input, I));
   --  Decodes the whole of Input into the first Length bytes of Output.
   --  OK is False, and Length 0, for whatever Encode never writes: a length
   --  that is no multiple of four, a foreign character, padding elsewhere
   --  than at the end, or left-over bits that are not zero.

   procedure Prove_Round_Trip (Input : Byte_Array; Length : Natural)
   with
     Ghost,
     Pre => Input'First = 1
       and then Length <= Input'Last
       and then Length <= Max_Input;
   --  Decode accepts what Encode writes, and gives Input back: asserted in
   --  the body.

end Base64;
