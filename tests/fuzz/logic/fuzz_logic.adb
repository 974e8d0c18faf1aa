--  SPDX-License-Identifier: GPL-3.0-or-later
--  bin/destijl_fuzz_logic TARGET [FILE ...]: gives the target each file, or
--  without one all inputs of afl-fuzz. Alone it names its targets.

with Ada.Characters.Handling; use Ada.Characters.Handling;
with Ada.Command_Line;        use Ada.Command_Line;
with Ada.Text_IO;             use Ada.Text_IO;
with Interfaces.C;            use Interfaces.C;
with Logic_Targets;           use Logic_Targets;

procedure Fuzz_Logic is

   function Replay (Path : char_array; Target : Receiver) return int
   with Import, Convention => C, External_Name => "fuzz_replay";

   procedure Run_All (Target : Receiver)
   with Import, Convention => C, External_Name => "fuzz_all";

begin
   if Argument_Count = 0 then
      for Target in Target_Kind loop
         Put_Line (To_Lower (Target'Image));
      end loop;
      return;
   end if;

   Choose (Target_Kind'Value (Argument (1)));
   if Argument_Count = 1 then
      Run_All (Give'Access);
   end if;
   for I in 2 .. Argument_Count loop
      if Replay (To_C (Argument (I)), Give'Access) /= 0 then
         Put_Line (Standard_Error, "cannot read " & Argument (I));
         Set_Exit_Status (Failure);
      end if;
   end loop;
end Fuzz_Logic;
