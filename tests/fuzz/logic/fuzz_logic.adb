--  SPDX-License-Identifier: GPL-3.0-or-later
--  bin/destijl_fuzz_logic: the fuzz targets of the pure packages.

with Ada.Characters.Handling; use Ada.Characters.Handling;
with Ada.Command_Line;
with Ada.Exceptions;
with Ada.Text_IO;             use Ada.Text_IO;
with Admission_Targets;
with Bytes;
with Interfaces.C;            use Interfaces.C;
with Interfaces.C.Strings;    use Interfaces.C.Strings;
with Robot_Targets;
with System;
with Text_Targets;

procedure Fuzz_Logic is

   type Target_Kind is (Lines, Frames, Sessions, Networks, Tokens, Arguments);

   type Receiver is access procedure
     (Target : int; Data : System.Address; Size : size_t)
   with Convention => C;

   Count : constant int
   with Import, Convention => C, External_Name => "gnat_argc";
   Arguments_Given : constant System.Address
   with Import, Convention => C, External_Name => "gnat_argv";

   function Fuzz_Main
     (Count     : int;
      Arguments : System.Address;
      Names     : chars_ptr_array;
      Target    : Receiver)
      return int
   with Import, Convention => C, External_Name => "fuzz_main";

   procedure Crash
   with Import, Convention => C, External_Name => "fuzz_crash", No_Return;

   procedure Give (Target : int; Data : System.Address; Size : size_t)
   with Convention => C;
   --  One input of Size bytes to the target at that position. Whatever is
   --  raised is said and ends the process with a signal: the fuzzer counts a
   --  crash

   procedure Give (Target : int; Data : System.Address; Size : size_t) is
      Input : Bytes.Byte_Array (1 .. Natural (Size))
      with Import, Address => Data;
   begin
      case Target_Kind'Val (Target) is
         when Lines     => Text_Targets.Lines (Input);
         when Frames    => Robot_Targets.Frames (Input);
         when Sessions  => Robot_Targets.Sessions (Input);
         when Networks  => Admission_Targets.Network_Lists (Input);
         when Tokens    => Admission_Targets.Tokens (Input);
         when Arguments => Text_Targets.Arguments (Input);
      end case;
   exception
      when Occurrence : others =>
         Put_Line
           (Standard_Error, Ada.Exceptions.Exception_Information (Occurrence));
         Crash;
   end Give;

   Names : chars_ptr_array (0 .. Target_Kind'Pos (Target_Kind'Last) + 1);
   --  the last one is null

begin
   for Target in Target_Kind loop
      Names (Target_Kind'Pos (Target)) := New_String (To_Lower (Target'Image));
   end loop;
   Ada.Command_Line.Set_Exit_Status
     (Ada.Command_Line.Exit_Status
        (Fuzz_Main (Count, Arguments_Given, Names, Give'Access)));
end Fuzz_Logic;
