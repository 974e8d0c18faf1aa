--  SPDX-License-Identifier: GPL-3.0-or-later
--  Reads base64, as Base64 writes it.

with Bytes; use Bytes;

package Base64_Texts is

   procedure Decode
     (Input  : String;
      Output : in out Byte_Array;
      Length : out Natural;
      OK     : out Boolean)
   with
     Pre  => Input'Last < Integer'Last
       and then Output'First = 1 and then Input'Length / 4 * 3 <= Output'Last,
     Post => Length <= Output'Last and then (if not OK then Length = 0);
   --  Decodes the whole of Input into the first Length bytes of Output. Not
   --  OK: what Base64.Encode never writes, such as a length that is no
   --  multiple of four, a foreign character, or left-over bits that are not
   --  zero

end Base64_Texts;
