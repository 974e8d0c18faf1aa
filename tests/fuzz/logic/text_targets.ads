--  SPDX-License-Identifier: GPL-3.0-or-later
--  Fuzz targets: what comes from the monitor, and the command line. Each
--  raises an exception where something is wrong, as a contract or a check of
--  the language does.

with Bytes;

package Text_Targets is

   procedure Lines (Data : Bytes.Byte_Array);
   --  Data as the monitor's stream: lines are cut out of it, each is parsed
   --  and its text kept for the log

   procedure Arguments (Data : Bytes.Byte_Array);
   --  Data as a command line, NUL or a line feed behind each argument

end Text_Targets;
