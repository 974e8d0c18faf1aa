--  SPDX-License-Identifier: GPL-3.0-or-later

with GNAT.OS_Lib;
with Interfaces.C; use Interfaces.C;
with Linux;        use Linux;

package body Console with
  SPARK_Mode    => Off,
  Refined_State => (Terminal => null)
is

   function Open (Path : char_array; Flags : int) return int
   with Import, Convention => C_Variadic_2, External_Name => "open";

   procedure Open_Streams;
   --  Opens closed standard streams. Otherwise a socket or the serial line
   --  could get their descriptors, and receive the log

   procedure Put_On (Descriptor : int; Line : String; Written : out Boolean);
   --  Writes all of it, or as much as is accepted

   procedure Open_Streams is
      Read_Write : constant := 2;  --  O_RDWR
      Found      : int;
   begin
      loop
         Found := Open (To_C ("/dev/null"), Read_Write);
         exit when Found not in 0 .. 2;
      end loop;
      if Found > 2 then
         Linux.Close (Found);
      end if;
   end Open_Streams;

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

   procedure Put_Log (Line : String) is
      Unused : Boolean;
   begin
      Put_On (2, Line, Unused);
   end Put_Log;

   procedure Put (Line : String; Written : out Boolean) is
   begin
      Put_On (1, Line, Written);
   end Put;

begin
   Open_Streams;
end Console;
