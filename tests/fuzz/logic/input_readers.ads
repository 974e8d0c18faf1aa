--  SPDX-License-Identifier: GPL-3.0-or-later
--  An input of the fuzzer, read from its beginning: the bytes decide what a
--  target does. Behind the end there are zeros.

with Bytes;

package Input_Readers is

   type Reader (Size : Natural) is record
      Data : Bytes.Byte_Array (1 .. Size);
      Used : Natural := 0;
   end record;

   function Is_Empty (R : Reader) return Boolean is (R.Used >= R.Size);

   function Remaining (R : Reader) return Natural is (R.Size - R.Used);

   procedure Take (R : in out Reader; B : out Bytes.Byte);
   --  The next byte

   procedure Take (R : in out Reader; C : out Character);
   --  The next byte as a character

   procedure Take
     (R : in out Reader; First, Last : Integer; Value : out Integer)
   with
     Pre  => First <= Last,
     Post => Value in First .. Last;
   --  The next four bytes, most significant one first, as a number of the
   --  range: every number of it is the number of some four bytes

   function Rest (R : Reader) return String
   with Post => Rest'Result'First = 1
     and then Rest'Result'Length = Remaining (R);
   --  All that has not been taken yet, which stays

end Input_Readers;
