--  SPDX-License-Identifier: GPL-3.0-or-later
--  The calls of the C library that the device bodies share, with the numbers
--  of the Linux kernel's interface. For the bodies in this folder only.

with GNAT.OS_Lib;

package body Linux with SPARK_Mode => Off is

   -----------
   -- Close --
   -----------

   procedure Close (Descriptor : int) is
      Ignored : constant int := Close (Descriptor);
      pragma Unreferenced (Ignored);
   begin
      null;
   end Close;

   ----------------
   -- Error_Text --
   ----------------

   function Error_Text (Number : Integer) return String is
     (GNAT.OS_Lib.Errno_Message (Number));

end Linux;
