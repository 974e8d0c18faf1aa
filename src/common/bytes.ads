--  SPDX-License-Identifier: GPL-3.0-or-later
--  Bytes of the serial line, the images and the sockets: one type for all
--  packages below the tasks.

with Interfaces;

package Bytes with Pure, SPARK_Mode is

   subtype Byte is Interfaces.Unsigned_8;

   type Byte_Array is array (Positive range <>) of Byte;

end Bytes;
