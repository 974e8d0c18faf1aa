--  SPDX-License-Identifier: GPL-3.0-or-later
--  Fuzz targets: who is admitted. Each raises an exception where something
--  is wrong, as a contract or a check of the language does.

with Bytes;

package Admission_Targets is

   procedure Network_Lists (Data : Bytes.Byte_Array);
   --  Data as networks, a line feed behind each, then behind a NUL the
   --  addresses of peers, sixteen bytes each

   procedure Tokens (Data : Bytes.Byte_Array);
   --  Data as the file of a token, then behind a NUL what a newcomer sends

end Admission_Targets;
