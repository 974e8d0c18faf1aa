--  SPDX-License-Identifier: GPL-3.0-or-later
--  The size of an image, from the frame header of its JPEG.

with Bytes; use type Bytes.Byte;

package body Jpeg_Headers is

   procedure Get_Size
     (Image  : Bytes.Byte_Array;
      Width  : out Natural;
      Height : out Natural)
   is
      subtype Offset is Natural range 0 .. Image'Length - 1;

      function Octet (At_Offset : Offset) return Bytes.Byte is
        (Image (Image'First + At_Offset));

      function Word (At_Offset : Offset) return Natural is
        (Natural (Octet (At_Offset)) * 256 + Natural (Octet (At_Offset + 1)));

      Position : Natural := 2;
      --  Of the next marker segment
   begin
      Width := 0;
      Height := 0;

      if Image'Length < 4
        or else Octet (0) /= 16#FF#
        or else Octet (1) /= 16#D8#
      then
         return;
      end if;

      --  A segment: FF, marker, length of the rest (2), the rest. In a
      --  frame header that is precision (1), height (2), width (2).
      while Position + 9 <= Image'Length and then Octet (Position) = 16#FF#
      loop
         case Octet (Position + 1) is
            when 16#FF# =>
               Position := Position + 1;  --  a fill byte
            when 16#C0# .. 16#C3# | 16#C5# .. 16#C7#
               | 16#C9# .. 16#CB# | 16#CD# .. 16#CF# =>
               Height := Word (Position + 5);
               Width := Word (Position + 7);
               return;
            when others =>
               Position := Position + 2 + Word (Position + 2);
         end case;
      end loop;
   end Get_Size;

end Jpeg_Headers;
