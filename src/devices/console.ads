--  SPDX-License-Identifier: GPL-3.0-or-later
--  The console: standard error for the log, standard output for what was
--  asked for. May wait, so for a task of low priority only.

package Console with
  SPARK_Mode,
  Abstract_State =>
    (Terminal with Synchronous, External => (Async_Readers, Async_Writers)),
  Initializes => Terminal
is

   procedure Put_Log (Line : String) with Global => (In_Out => Terminal);
   --  Line and a line feed in one write on standard error. Where nobody
   --  takes it (closed, full disk), it is lost

   procedure Put (Line : String; Written : out Boolean)
   with Global => (In_Out => Terminal);
   --  The same on standard output; Written is whether all of it was taken

end Console;
