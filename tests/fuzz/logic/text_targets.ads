--  SPDX-License-Identifier: GPL-3.0-or-later
--  Fuzz targets: texts and numbers, and the command line. Each raises an
--  exception where something is wrong, as a contract or a check of the
--  language does.

with Bytes;

package Text_Targets is

   procedure Arguments (Data : Bytes.Byte_Array);
   --  Data as a command line, NUL or a line feed behind each argument

   procedure Base64_Texts (Data : Bytes.Byte_Array);
   --  Data as Base64 to be read, then as bytes to be written in it

   procedure Decimal_Numbers (Data : Bytes.Byte_Array);
   --  Data as digits to be read, then as numbers to be written

   procedure Bounded_Texts (Data : Bytes.Byte_Array);
   --  Data as operations on a text of bounded length

end Text_Targets;
