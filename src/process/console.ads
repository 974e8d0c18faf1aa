--  SPDX-License-Identifier: GPL-3.0-or-later
--  The console: standard error for the log, standard output for requested
--  output. May wait, so only for tasks of low priority.

with Process;

package Console with SPARK_Mode is

   Max_Line : constant := 2 ** 24;
   --  Characters, with the line feed

   procedure Write
     (To    : Process.Descriptor;
      Text  : String;
      Error : in out Process.Error_Number)
   with
     Global   => (In_Out => Process.System_State),
     Annotate => (GNATprove, Terminating);
   --  Writes all of Text, or as much as is accepted before an Error. No effect
   --  after one

   procedure Put_Log (Line : String)
   with
     Global => (In_Out => Process.System_State),
     Pre    => Line'Length < Max_Line;
   --  Line and a line feed in one write on standard error. It is lost if it
   --  cannot be written (closed, full disk)

   procedure Put (Line : String; Written : out Boolean)
   with
     Global => (In_Out => Process.System_State),
     Pre    => Line'Length < Max_Line;
   --  The same on standard output; Written: all of it was accepted

   procedure Cannot_Start (Why : String)
   with
     Global => (In_Out => Process.System_State),
     Pre    => Why'Length < Max_Line / 2,
     No_Return;
   --  Says why on standard error, and ends the process

end Console;
