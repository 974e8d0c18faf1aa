--  SPDX-License-Identifier: GPL-3.0-or-later
--  Fuzz targets: what comes from the robot. Each raises an exception where
--  something is wrong, as a contract or a check of the language does.

with Bytes;

package Robot_Targets is

   procedure Frames (Data : Bytes.Byte_Array);
   --  Data as what the serial line delivers, then as one frame: read as the
   --  answer to each command; and as commands to be written

   procedure Sessions (Data : Bytes.Byte_Array);
   --  Data as requests of the monitor and answers of the robot in turn

end Robot_Targets;
