--  SPDX-License-Identifier: GPL-3.0-or-later
--  Waiting for descriptors.

with Interfaces.C; use Interfaces.C;
with System;

package body Polls is

   procedure Wait (Files : in out Libc.Poll_Array; Span : Duration) is
      Billion : constant := 1_000_000_000;
      Left    : constant Long_Long_Integer :=
        Long_Long_Integer'Integer_Value (Duration'Max (0.0, Span));
      Time    : aliased constant Libc.Timespec :=
        (long (Left / Billion), long (Left mod Billion));
   begin
      for File of Files loop
         File.Returned := 0;
      end loop;
      if Libc.Ppoll
           (Files'Address, Files'Length, Time'Access, System.Null_Address)
        <= 0
      then
         for File of Files loop
            File.Returned := 0;
         end loop;
      end if;
   end Wait;

   function Is_Readable
     (File : Interfaces.C.int; Span : Duration) return Boolean
   is
      Files : Libc.Poll_Array (1 .. 1) := (1 => (File, Libc.Poll_In, 0));
   begin
      Wait (Files, Span);
      return Files (1).Returned /= 0;
   end Is_Readable;

end Polls;
