--  SPDX-License-Identifier: GPL-3.0-or-later
--  The octets that the serial line, the images and the sockets carry, as
--  one type that every package below the tasks shares.

with Interfaces;

package Bytes with Pure, SPARK_Mode is

   subtype Byte is Interfaces.Unsigned_8;

   type Byte_Array is array (Positive range <>) of Byte;

end Bytes;
