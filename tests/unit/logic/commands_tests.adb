--  SPDX-License-Identifier: GPL-3.0-or-later
--  The table of commands: the robot's frame for each line of the monitor, and
--  what is by hand.

with AUnit.Assertions; use AUnit.Assertions;

with Commands;         use Commands;
with Monitor.Protocol; use Monitor.Protocol;
with Robot.Protocol;
with Robot.Session;
with Unit_Runs; use Unit_Runs;

procedure Commands_Tests is

   procedure Check_Frame (Line, Expected : String) is
      --  The robot gets Expected, a checksum and a carriage return for Line.
      C : Command;
      F : Robot.Protocol.Frame;
   begin
      Parse (Line, C);
      Robot.Protocol.Encode (Robot.Session.Command_For (Request_Of (C)), F);
      Assert (F.Length = Expected'Length + 2, Line & ": length");
      for I in Expected'Range loop
         Assert (Character'Val (F.Data (I)) = Expected (I),
                 Line & ": character" & I'Image);
      end loop;
   end Check_Frame;

   procedure Test_Frames is
   begin
      Check_Frame ("ROPN", "r");
      Check_Frame ("RCLS", "M=0");
      Check_Frame ("RSOW", "u");
      Check_Frame ("RSWW", "W");
      Check_Frame ("RRST", "r");
      Check_Frame ("RPIN", "p");
      Check_Frame ("RLDW", "w");
      Check_Frame ("RGFW", "M=32767");
      Check_Frame ("RGBW", "M=-32768");
      Check_Frame ("RGLF", "T=32767");
      Check_Frame ("RGRI", "T=-32768");
      Check_Frame ("RSTP", "M=0");
      Check_Frame ("MABT", "M=0");
      Check_Frame ("RMOV:120", "M=120");
      Check_Frame ("RTRN:-90", "T=-90");
      Check_Frame ("RPOF", "z");
      Check_Frame ("RGBT", "v");
      Check_Frame ("RGST", "b");
      Check_Frame ("RVER", "V");
   end Test_Frames;

   procedure Test_Hand is
   begin
      for Name in Command_Name loop
         Assert (Is_By_Hand (Name) =
                   (Name in Close_Robot | Reset_Robot | Power_Off_Robot
                      | Go_Forward | Go_Backward | Go_Left | Go_Right
                      | Move_Robot | Turn_Robot | Stop_Robot | Abort_Mission),
                 Name'Image);
      end loop;
   end Test_Hand;

begin
   Run_Test ("the robot's frames", Test_Frames'Access);
   Run_Test ("orders by hand", Test_Hand'Access);
end Commands_Tests;
