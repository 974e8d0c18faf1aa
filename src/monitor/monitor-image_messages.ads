--  SPDX-License-Identifier: GPL-3.0-or-later
--  Messages that carry an image. They are large, so they are passed by
--  reference, with one owner at a time, which GNATprove checks.

package Monitor.Image_Messages with SPARK_Mode is

   Max_Jpeg : constant := 1_048_575;
   --  Bytes of the largest image that can be sent (a multiple of 3)

   Max_Message : constant := 5 + Max_Jpeg / 3 * 4 + 1;
   --  Characters of its message: label, base64, line feed

   subtype Message_Buffer is String (1 .. Max_Message);
   subtype Message_Length is Natural range 0 .. Max_Message;

   type Message is record
      Data   : Message_Buffer := (others => ' ');
      Length : Message_Length := 0;
   end record;
   --  The first Length characters of Data are valid

   type Message_Access is access Message;

end Monitor.Image_Messages;
