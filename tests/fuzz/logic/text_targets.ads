--  SPDX-License-Identifier: GPL-3.0-or-later
--  Fuzz targets: the command line, and Base64. Each raises an exception where
--  something is wrong, as a contract or a check of the language does.

with Bytes;

package Text_Targets is

   procedure Arguments (Data : Bytes.Byte_Array);
   --  Data as a command line, NUL or a line feed behind each argument

   procedure Base64_Texts (Data : Bytes.Byte_Array);
   --  Data as Base64 to be read, then as bytes to be written in it

end Text_Targets;
