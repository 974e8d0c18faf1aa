--  SPDX-License-Identifier: GPL-3.0-or-later

with Base64; use Base64;

package body Base64_Texts is

   No_Symbol : constant := 64;

   function Value_Of (C : Character) return Natural is
     (case C is
         when 'A' .. 'Z' => Character'Pos (C) - Character'Pos ('A'),
         when 'a' .. 'z' => Character'Pos (C) - Character'Pos ('a') + 26,
         when '0' .. '9' => Character'Pos (C) - Character'Pos ('0') + 52,
         when '+'        => 62,
         when '/'        => 63,
         when others     => No_Symbol);

   procedure Decode
     (Input  : String;
      Output : in out Byte_Array;
      Length : out Natural;
      OK     : out Boolean)
   is
      Groups         : constant Natural := Input'Length / 4;
      First          : Positive;
      Count          : Positive range 1 .. 3;
      --  of a group: its first character, its number of bytes
      V1, V2, V3, V4 : Natural range 0 .. No_Symbol;
   begin
      Length := 0;
      OK     := Input'Length mod 4 = 0;
      if not OK then
         return;
      end if;
      for K in 0 .. Groups - 1 loop
         First := Input'First + 4 * K;
         Count :=
           (if K < Groups - 1 or else Input (First + 3) /= Padding then 3
            elsif Input (First + 2) /= Padding then 2
            else 1);
         V1 := Value_Of (Input (First));
         V2 := Value_Of (Input (First + 1));
         V3 := (if Count < 2 then 0 else Value_Of (Input (First + 2)));
         V4 := (if Count < 3 then 0 else Value_Of (Input (First + 3)));
         if Natural'Max (Natural'Max (V1, V2), Natural'Max (V3, V4))
             = No_Symbol
           or else (Count = 1 and then V2 mod 16 /= 0)
           or else (Count = 2 and then V3 mod 4 /= 0)
         then
            Length := 0;
            OK     := False;
            return;
         end if;
         Output (Length + 1) := Byte (V1 * 4 + V2 / 16);
         if Count > 1 then
            Output (Length + 2) := Byte (V2 mod 16 * 16 + V3 / 4);
         end if;
         if Count > 2 then
            Output (Length + 3) := Byte (V3 mod 4 * 64 + V4);
         end if;
         Length := Length + Count;
      end loop;
   end Decode;

end Base64_Texts;
