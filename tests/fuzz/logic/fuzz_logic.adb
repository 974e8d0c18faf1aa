--  SPDX-License-Identifier: GPL-3.0-or-later
--  bin/destijl_fuzz_logic: the fuzz targets of the pure packages.

with Ada.Characters.Handling; use Ada.Characters.Handling;
with Ada.Command_Line;
with Interfaces.C;            use Interfaces.C;
with Interfaces.C.Strings;    use Interfaces.C.Strings;
with Logic_Targets;           use Logic_Targets;
with System;

procedure Fuzz_Logic is

   Count : constant int
   with Import, Convention => C, External_Name => "gnat_argc";
   Arguments : constant System.Address
   with Import, Convention => C, External_Name => "gnat_argv";

   function Fuzz_Main
     (Count     : int;
      Arguments : System.Address;
      Names     : chars_ptr_array;
      Target    : Receiver)
      return int
   with Import, Convention => C, External_Name => "fuzz_main";

   Last  : constant size_t := Target_Kind'Pos (Target_Kind'Last);
   Names : chars_ptr_array (0 .. Last + 1);
   --  the last one is null

begin
   for Target in Target_Kind loop
      Names (Target_Kind'Pos (Target)) := New_String (To_Lower (Target'Image));
   end loop;
   Ada.Command_Line.Set_Exit_Status
     (Ada.Command_Line.Exit_Status
        (Fuzz_Main (Count, Arguments, Names, Give'Access)));
end Fuzz_Logic;
