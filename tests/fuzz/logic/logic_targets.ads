--  SPDX-License-Identifier: GPL-3.0-or-later
--  All fuzz targets of the pure packages, in the form in which fuzz_engine.h
--  calls them.

with Interfaces.C;
with System;

package Logic_Targets is

   type Target_Kind is (Lines, Frames, Sessions, Networks, Tokens, Arguments);

   procedure Give
     (Target : Interfaces.C.int;
      Data   : System.Address;
      Size   : Interfaces.C.size_t)
   with Convention => C;
   --  One input of Size bytes to the target at that position. Whatever is
   --  raised is said and ends the process with a signal: the fuzzer counts a
   --  crash

   type Receiver is access procedure
     (Target : Interfaces.C.int;
      Data   : System.Address;
      Size   : Interfaces.C.size_t)
   with Convention => C;

end Logic_Targets;
