--  SPDX-License-Identifier: GPL-3.0-or-later
--  The buffers for images, too large for a stack.

with Interfaces.C; use Interfaces.C;

with Bytes;
with Monitor.Outbox;

package Image_Buffers is

   Canvas : array (1 .. 1_920 * 1_080 * 3) of aliased unsigned_char;
   --  Pixels

   Source : Bytes.Byte_Array (1 .. 2_000_000);
   --  The camera's image

   Jpeg : Bytes.Byte_Array (1 .. Monitor.Outbox.Max_Jpeg) :=
     (others => 0);
   Text : Monitor.Outbox.Message_Buffer := (others => ' ');
   --  The result

end Image_Buffers;
