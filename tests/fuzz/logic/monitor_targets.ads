--  SPDX-License-Identifier: GPL-3.0-or-later
--  Fuzz targets: what comes from the monitor. Each raises an exception
--  where something is wrong, as a contract or a check of the language does.

with Bytes;

package Monitor_Targets is

   procedure Lines (Data : Bytes.Byte_Array);
   --  Data as the monitor's stream: lines are cut out of it, each is parsed
   --  and its text kept for the log

end Monitor_Targets;
