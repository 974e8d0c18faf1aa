--  SPDX-License-Identifier: GPL-3.0-or-later
--  The table of commands: the robot's frame for each line of the monitor, what
--  is by hand; and the ranks.

with AUnit.Assertions; use AUnit.Assertions;

with Commands;         use Commands;
with Monitor.Protocol; use Monitor.Protocol;
with Orders;           use Orders;
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

   procedure Check_Rank
     (R : in out Ranks; Name : Command_Name; Rank, After : Ticket)
   is
      --  as the task has it that receives: with what the last order left
      Item : Order :=
        (Command => (Name, 0), Rank => 99, After => 99, others => <>);
   begin
      Give_Rank (R, Item);
      Assert (Item.Rank = Rank, Name'Image & " has rank" & Item.Rank'Image);
      Assert (Item.After = After, Name'Image & " after" & Item.After'Image);
   end Check_Rank;

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
         Assert
           (Is_By_Hand (Name) =
              (Name in Close_Robot | Reset_Robot | Power_Off_Robot
                 | Go_Forward | Go_Backward | Go_Left | Go_Right
                 | Move_Robot | Turn_Robot | Stop_Robot | Abort_Mission),
            Name'Image);
      end loop;
   end Test_Hand;

   procedure Test_Ranks is
      R : Ranks;
   begin
      Check_Rank (R, Open_Robot, 1, 0);
      Check_Rank (R, Ping_Robot, 2, 1);
      Check_Rank (R, Stop_Robot, 0, 0);
      Check_Rank (R, Abort_Mission, 0, 0);
      Check_Rank (R, Open_Camera, 0, 0);
      Check_Rank (R, Go_To_Pixels, 0, 2);
      --  a mission follows all orders before it

      Check_Rank (R, Start_Robot, 3, 1);
      Check_Rank (R, Go_Left, 4, 3);
      Check_Rank (R, Power_Off_Robot, 5, 3);
      Check_Rank (R, Get_State, 6, 5);
   end Test_Ranks;

begin
   Run_Test ("the robot's frames", Test_Frames'Access);
   Run_Test ("orders by hand", Test_Hand'Access);
   Run_Test ("the ranks", Test_Ranks'Access);
end Commands_Tests;
