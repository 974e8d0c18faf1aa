--  SPDX-License-Identifier: GPL-3.0-or-later
--  Base64 with padding and without line breaks (RFC 4648, section 4), as
--  the images travel to the monitor.

with Bytes; use Bytes;

package Base64 with SPARK_Mode is

   Max_Input : constant := 2 ** 28;
   --  Bytes in one encoding; keeps every length in the range of Natural.

   subtype Input_Length is Natural range 0 .. Max_Input;

   function Encoded_Length (Length : Input_Length) return Natural is
     ((Length + 2) / 3 * 4);
   --  Characters that Length bytes become: four for every three begun.

   --  The words of the contracts

   subtype Sextet is Natural range 0 .. 63;

   function Symbol (Value : Sextet) return Character is
     (if Value < 26 then Character'Val (Character'Pos ('A') + Value)
      elsif Value < 52 then Character'Val (Character'Pos ('a') + Value - 26)
      elsif Value < 62 then Character'Val (Character'Pos ('0') + Value - 52)
      elsif Value = 62 then '+'
      else '/')
   with Ghost;
   --  The alphabet of RFC 4648, table 1.

   function Is_Symbol (C : Character) return Boolean is
     (C in 'A' .. 'Z' | 'a' .. 'z' | '0' .. '9' | '+' | '/');

   function Is_Triple (B1, B2, B3 : Byte; C1, C2, C3, C4 : Character)
     return Boolean
   is (C1 = Symbol (Natural (B1) / 4)
       and then C2 = Symbol (Natural (B1) mod 4 * 16 + Natural (B2) / 16)
       and then C3 = Symbol (Natural (B2) mod 16 * 4 + Natural (B3) / 64)
       and then C4 = Symbol (Natural (B3) mod 64))
   with Ghost;
   --  Three bytes and their four characters.

   function Is_Pair (B1, B2 : Byte; C1, C2, C3, C4 : Character)
     return Boolean
   is (C1 = Symbol (Natural (B1) / 4)
       and then C2 = Symbol (Natural (B1) mod 4 * 16 + Natural (B2) / 16)
       and then C3 = Symbol (Natural (B2) mod 16 * 4)
       and then C4 = '=')
   with Ghost;
   --  The last two bytes of an input and their four characters.

   function Is_Single (B1 : Byte; C1, C2, C3, C4 : Character) return Boolean
   is (C1 = Symbol (Natural (B1) / 4)
       and then C2 = Symbol (Natural (B1) mod 4 * 16)
       and then C3 = '='
       and then C4 = '=')
   with Ghost;
   --  The last byte of an input and its four characters.

   function Is_Encoding
     (Text   : String;
      First  : Positive;
      Input  : Byte_Array;
      Length : Natural) return Boolean
   is ((for all K in 0 .. Length / 3 - 1 =>
          Is_Triple (Input (3 * K + 1), Input (3 * K + 2), Input (3 * K + 3),
                     Text (First + 4 * K), Text (First + 4 * K + 1),
                     Text (First + 4 * K + 2), Text (First + 4 * K + 3)))
       and then
         (if Length mod 3 = 2 then
             Is_Pair (Input (Length - 1), Input (Length),
                      Text (First + Length / 3 * 4),
                      Text (First + Length / 3 * 4 + 1),
                      Text (First + Length / 3 * 4 + 2),
                      Text (First + Length / 3 * 4 + 3)))
       and then
         (if Length mod 3 = 1 then
             Is_Single (Input (Length),
                        Text (First + Length / 3 * 4),
                        Text (First + Length / 3 * 4 + 1),
                        Text (First + Length / 3 * 4 + 2),
                        Text (First + Length / 3 * 4 + 3))))
   with
     Ghost,
     Pre => Input'First = 1
       and then Length <= Input'Last
       and then Length <= Max_Input
       and then First >= Text'First
       and then First - 1 <= Text'Last - Encoded_Length (Length);
   --  Text holds, from First on, the encoding of the first Length bytes of
   --  Input. It says by itself how long the text is, which characters it
   --  is made of and how it is padded.

   function Value_Of (C : Character) return Sextet is
     (case C is
         when 'A' .. 'Z' => Character'Pos (C) - Character'Pos ('A'),
         when 'a' .. 'z' => Character'Pos (C) - Character'Pos ('a') + 26,
         when '0' .. '9' => Character'Pos (C) - Character'Pos ('0') + 52,
         when '+'        => 62,
         when others     => 63)
   with
     Pre  => Is_Symbol (C),
     Post => Symbol (Value_Of'Result) = C;

   function Is_Last_Group (C1, C2, C3, C4 : Character) return Boolean is
     (Is_Symbol (C1)
      and then Is_Symbol (C2)
      and then
        (if C4 /= '=' then Is_Symbol (C3) and then Is_Symbol (C4)
         elsif C3 /= '=' then
            Is_Symbol (C3) and then Value_Of (C3) mod 4 = 0
         else Value_Of (C2) mod 16 = 0))
   with Ghost;

   function Is_Well_Formed (Text : String) return Boolean is
     (Text'Length mod 4 = 0
      and then
        (for all K in 0 .. Text'Length / 4 - 2 =>
           Is_Symbol (Text (Text'First + 4 * K))
           and then Is_Symbol (Text (Text'First + 4 * K + 1))
           and then Is_Symbol (Text (Text'First + 4 * K + 2))
           and then Is_Symbol (Text (Text'First + 4 * K + 3)))
      and then
        (if Text'Length > 0 then
            Is_Last_Group (Text (Text'Last - 3), Text (Text'Last - 2),
                           Text (Text'Last - 1), Text (Text'Last))))
   with
     Ghost,
     Pre => Text'Last < Integer'Last;
   --  Some input has this encoding.

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
       and then First - 1 <= Output'Last - Encoded_Length (Length),
     Post => Last = First - 1 + Encoded_Length (Length)
       and then Is_Encoding (Output, First, Input, Length)
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
       and then Output'Last <= Max_Input
       and then Input'Length / 4 * 3 <= Output'Last,
     Post => OK = Is_Well_Formed (Input)
       and then Length <= Input'Length / 4 * 3
       and then
         (if OK then
             Input'Length = Encoded_Length (Length)
             and then Is_Encoding (Input, Input'First, Output, Length))
       and then (if not OK then Length = 0);
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
