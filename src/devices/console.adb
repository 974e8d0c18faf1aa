--  SPDX-License-Identifier: GPL-3.0-or-later
--  The console: standard error for the log, standard output for what was
--  asked for. May wait, so for a task of low priority only.

with GNAT.OS_Lib;
with Interfaces.C; use Interfaces.C;
with Linux;        use Linux;

package body Console with
  SPARK_Mode    => Off,
  Refined_State => (Terminal => null)
is

   procedure Put_On (Descriptor : int; Line : String; Written : out Boolean);
   --  All of it, or as much as is taken

   ------------
   -- Put_On --
   ------------

   procedure Put_On (Descriptor : int; Line : String; Written : out Boolean)
   is
      Text : constant String := Line & ASCII.LF;
      Next : Positive := Text'First;
      Done : Ssize;
   begin
      while Next <= Text'Last loop
         Done := Linux.Write
           (Descriptor, Text (Next)'Address, size_t (Text'Last - Next + 1));
         if Done > 0 then
            Next := Next + Positive (Done);
         else
            exit when GNAT.OS_Lib.Errno /= EINTR;
         end if;
      end loop;
      Written := Next > Text'Last;
   end Put_On;

   -------------
   -- Put_Log --
   -------------

   procedure Put_Log (Line : String) is
      Unused : Boolean;
   begin
      Put_On (2, Line, Unused);
   end Put_Log;

   ---------
   -- Put --
   ---------

   procedure Put (Line : String; Written : out Boolean) is
   begin
      Put_On (1, Line, Written);
   end Put;

end Console;
