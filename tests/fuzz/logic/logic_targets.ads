--  SPDX-License-Identifier: GPL-3.0-or-later
--  All fuzz targets of the pure packages, by their names, in the form in
--  which fuzz_engine.h calls them.

with Interfaces.C;
with System;

package Logic_Targets is

   type Target_Kind is
     (Lines, Frames, Commands, Sessions, Networks, Tokens, Arguments, Base64);

   procedure Choose (Target : Target_Kind);
   --  What Give gives its inputs to

   procedure Give (Data : System.Address; Size : Interfaces.C.size_t)
   with Convention => C;
   --  One input of Size bytes. Whatever is raised is said and ends the
   --  process with a signal: the fuzzer counts a crash

   type Receiver is access procedure
     (Data : System.Address; Size : Interfaces.C.size_t)
   with Convention => C;

end Logic_Targets;
