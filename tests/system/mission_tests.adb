--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Child_Processes;       use Child_Processes;
with Emulators;
with Expectations;          use Expectations;
with Instants;              use Instants;
with Monitor_Clients;       use Monitor_Clients;
with Rigs;                  use Rigs;
with Scenarios;             use Scenarios;

package body Mission_Tests is

   procedure Path_Is_Driven;
   procedure Point_In_The_Image;
   procedure Refused_With_Reason;
   procedure Refused_As_Arena_Too_Small;
   procedure Malformed_Paths;
   procedure One_At_A_Time;
   procedure Ended_By_Hand;
   procedure Ended_By_Abort;
   procedure Not_Ended_By_Questions;
   procedure Ended_By_Lost_Monitor;
   procedure Ended_By_Stalled_Camera;
   procedure Ended_By_Robot_Out_Of_Sight;
   procedure Ended_By_Positions_Off;
   procedure Ended_By_Lost_Robot;
   procedure Ended_By_Reset_Robot;

   Near  : constant String := "MPCM:52;38;28;38";
   Far   : constant String := "MGCM:68;48";
   --  From where the robot stands at first, the middle of the arena

   Stop_Limit : constant Duration := 0.4;
   --  without a position, until the robot is stopped

   procedure Prepare (R : in out Rig; Watchdog : Boolean := False);
   --  All that a mission needs

   procedure Confirm_Arena (R : in out Rig);

   procedure Refuse (R : in out Rig; Order, Reason : String);

   procedure Begin_Drive (R : in out Rig);
   --  A mission to Far is under way, and the robot moves

   procedure Expect_End
     (R : in out Rig; Text : String; Within : Duration := 3.0);
   --  The one end of the one mission

   procedure Expect_Nothing_After (R : in out Rig; Command : String);
   --  The last order on the wire is Command, and stays the last

   function Off_By (X, Y, To_X, To_Y : Float) return Float is
     (Float'Max (abs (X - To_X), abs (Y - To_Y)));

   procedure Confirm_Arena (R : in out Rig) is
      Unused : Message;
   begin
      Check (R.Monitor.Ask ("CASA", Within => 5.0).Label = "CIMG",
             "no arena");
      delay 0.3;
      R.Monitor.Send_Line ("CACO");
      R.Monitor.Skip_To_Now;
      for Number in 1 .. 3 loop
         Unused := R.Monitor.Next_Of ("CIMG", Within => 5.0);
      end loop;
   end Confirm_Arena;

   procedure Prepare (R : in out Rig; Watchdog : Boolean := False) is
   begin
      Assemble (R, Camera => True);
      Start_Robot (R, Watchdog);
      Open_Camera (R, Positions => True);
      Confirm_Arena (R);
      R.Emulator.Clear_Journal;
   end Prepare;

   procedure Refuse (R : in out Rig; Order, Reason : String) is
      Item : Message;
   begin
      R.Monitor.Expect (Order, "ANAK");
      Item := R.Monitor.Next_Of ("MSSG", Within => 2.0);
      Check
        (To_String (Item.Data) = "mission not possible: " & Reason,
         Order & " is refused by: " & To_String (Item.Data));
   end Refuse;

   procedure Begin_Drive (R : in out Rig) is
   begin
      R.Monitor.Expect (Far, "AACK");
      R.Emulator.Await_Status ("moving", "1", Within => 3.0);
   end Begin_Drive;

   procedure Expect_End
     (R : in out Rig; Text : String; Within : Duration := 3.0)
   is
      Item : constant Message := R.Monitor.Next_Of ("MEND", Within);
   begin
      Check (To_String (Item.Data) = Text,
             "the end is " & To_String (Item.Data) & ", not " & Text);
      R.Monitor.Expect_Silence ("MEND MPRG", For_Time => 0.5);
      Check (R.Monitor.Count_Of ("MEND") = 1, "more than one end");
   end Expect_End;

   procedure Expect_Nothing_After (R : in out Rig; Command : String) is
      Before : constant String := R.Emulator.Wire_Text;
   begin
      Check (Tail (Before, Command'Length + 1) = Command & " ",
             "the last order is not " & Command & ": " & Before);
      delay 0.7;
      Check (R.Emulator.Wire_Text = Before,
             "orders after " & Command & ": " & R.Emulator.Wire_Text);
   end Expect_Nothing_After;

   procedure Path_Is_Driven is
      R        : Rig;
      Item     : Message;
      Leg      : Natural := 0;
      Reported : Natural := 0;
   begin
      Prepare (R, Watchdog => True);
      R.Monitor.Skip_To_Now;
      R.Monitor.Expect (Near, "AACK");
      loop
         Item := R.Monitor.Next_Of ("MPRG MEND", Within => 3.0);
         exit when Item.Label = "MEND";
         Reported := Reported + 1;
         declare
            Text : constant String := To_String (Item.Data);
         begin
            if Head (Text, 4) = "1;2;" then
               Check (Leg <= 1, "back to the first leg");
               Leg := 1;
            else
               Check (Head (Text, 4) = "2;2;", "progress " & Text);
               Leg := 2;
            end if;
            Check (Natural'Value (Text (5 .. Text'Last)) <= 400,
                   "further than its points are apart: " & Text);
         end;
      end loop;
      Check (To_String (Item.Data) = "done", "ends " & To_String (Item.Data));
      Check (Leg = 2 and then Reported >= 2, "progress not told");
      declare
         Now : constant Emulators.Truth := R.Emulator.Pose;
      begin
         Note ("off by " & Off_By (Now.X, Now.Y, 28.0, 38.0)'Image & " cm");
         Check (Off_By (Now.X, Now.Y, 28.0, 38.0) <= 1.5,
                "the robot is elsewhere");
      end;
      Expect_Nothing_After (R, "M=0");

      --  and the next, at once

      R.Monitor.Expect ("MGCM:40;30", "AACK");
      Item := R.Monitor.Next_Of ("MEND", Within => 20.0);
      Check (To_String (Item.Data) = "done", "ends " & To_String (Item.Data));
      Check (R.Emulator.Status ("state") in "run" | "movement",
             "the watchdog has ended the run");
   end Path_Is_Driven;

   procedure Point_In_The_Image is
      R    : Rig;
      Item : Message;
   begin
      Prepare (R);
      R.Monitor.Expect ("MGTO:250.5;180", "AACK");
      Item := R.Monitor.Next_Of ("MEND", Within => 20.0);
      Check (To_String (Item.Data) = "done", "ends " & To_String (Item.Data));
      declare
         Now : constant Emulators.Truth := R.Emulator.Pose;
      begin
         Note ("off by " & Off_By (Now.Cx, Now.Cy, 250.5, 180.0)'Image
               & " px");
         Check (Off_By (Now.Cx, Now.Cy, 250.5, 180.0) <= 10.0,
                "the robot is elsewhere");
      end;
   end Point_In_The_Image;

   procedure Refused_With_Reason is
      R      : Rig;
      Unused : Message;
   begin
      Assemble (R, Camera => True);
      Refuse (R, Far, "robot not started");
      R.Monitor.Expect ("ROPN", "AACK");
      Refuse (R, Far, "robot not started");
      R.Monitor.Expect ("RSOW", "AACK");
      Refuse (R, Far, "camera closed");
      Open_Camera (R);
      Refuse (R, Far, "positions off");
      R.Monitor.Expect ("CPCO", "AACK");
      Unused := R.Monitor.Next_Of ("CPOS", Within => 5.0);
      Refuse (R, Far, "arena not confirmed");
      Refuse (R, "MGTO:320;240", "arena not confirmed");
      Confirm_Arena (R);
      for Order of Words
        ("MGCM:7;30 MGCM:73;30 MGCM:40;-3 MGCM:40;9999999 MGTO:0;0"
         & " MPTH:320;240;-99999;240")
      loop
         Refuse (R, Order, "a point is outside the arena less its margin");
      end loop;
      R.Emulator.Tell ("camera stall");
      delay 0.6;
      Refuse (R, Far, "robot not seen, or more than one");
      R.Emulator.Tell ("camera on");
      Unused := R.Monitor.Next_Of ("CPOS", Within => 5.0);
      R.Monitor.Expect_Silence ("MEND MPRG", For_Time => 0.3);
      Check (R.Emulator.Wire_Text = "",
             "a mission that was refused: " & R.Emulator.Wire_Text);
   end Refused_With_Reason;

   procedure Refused_As_Arena_Too_Small is
      R : Rig;
   begin
      Assemble
        (R, Camera          => True,
         Emulator_Options   => "--frame-size 160x120 --noise 0",
         Supervisor_Options => "--frame-size 160x120");
      Start_Robot (R);
      Open_Camera (R, Positions => True);
      Confirm_Arena (R);
      Refuse (R, Far, "arena too small in the image");
   end Refused_As_Arena_Too_Small;

   procedure Malformed_Paths is
      R : Rig;
   begin
      Assemble (R);
      for Order of Words
        ("MGTO MGTO: MGTO:1 MGTO:1; MGTO:1;2;3;4 MGTO:1;x MGTO:+1;2"
         & " MGTO:12345678;1 MGTO:1.1234567;1 MGCM:1;2;3;4 MPTH: MPTH:1"
         & " MPTH:1;2;3 MPCM:1,2 MABT:1")
      loop
         R.Monitor.Expect (Order, "ACER");
      end loop;
      R.Monitor.Expect ("MPTH:" & 63 * "1;2;" & "1;2", "ANAK");
      R.Monitor.Expect ("MPTH:" & 64 * "1;2;" & "1;2", "ACER");
      R.Monitor.Expect ("MABT", "ANAK");
   end Malformed_Paths;

   procedure One_At_A_Time is
      R : Rig;
   begin
      Prepare (R);
      Begin_Drive (R);
      R.Monitor.Expect (Far, "ACRJ");
      R.Monitor.Expect ("MPTH:320;240", "ACRJ");
      R.Monitor.Expect ("RPIN", "AACK");
      Expect_End (R, "done", Within => 20.0);
   end One_At_A_Time;

   procedure Ended_By_Hand is

      procedure End_By (Order, On_Wire : String);

      procedure End_By (Order, On_Wire : String) is
         R : Rig;
      begin
         Prepare (R);
         Begin_Drive (R);
         R.Monitor.Expect (Order, "AACK");
         Expect_End (R, "aborted;order by hand");
         Expect_Nothing_After (R, On_Wire);
      end End_By;

   begin
      End_By ("RSTP", "M=0");
      End_By ("RGFW", "M=32767");
      End_By ("RTRN:15", "T=15");
      End_By ("RCLS", "M=0");
   end Ended_By_Hand;

   procedure Ended_By_Abort is
      R    : Rig;
      Item : Message;
   begin
      Prepare (R);
      Begin_Drive (R);
      R.Monitor.Expect ("MABT", "AACK");
      Expect_End (R, "aborted;order by hand");
      Expect_Nothing_After (R, "M=0");
      R.Emulator.Await_Status ("moving", "0", Within => 1.0);

      --  without one it stops the robot just so

      R.Monitor.Expect ("RGLF", "AACK");
      R.Monitor.Expect ("MABT", "AACK");
      R.Emulator.Await_Status ("moving", "0", Within => 1.0);

      --  and then another may begin

      R.Monitor.Expect ("MGCM:40;30", "AACK");
      Item := R.Monitor.Next_Of ("MEND", Within => 20.0);
      Check (To_String (Item.Data) = "done", "ends " & To_String (Item.Data));
   end Ended_By_Abort;

   procedure Not_Ended_By_Questions is
      R : Rig;
   begin
      Prepare (R);
      Begin_Drive (R);
      R.Monitor.Expect ("RPIN", "AACK");
      R.Monitor.Expect ("RGBT", "RBLV");
      R.Monitor.Expect ("RGST", "RCST");
      Expect_End (R, "done", Within => 20.0);
   end Not_Ended_By_Questions;

   procedure Ended_By_Lost_Monitor is
      R : Rig;
   begin
      Prepare (R);
      Begin_Drive (R);
      R.Monitor.Reset;
      R.Emulator.Await_Status ("moving", "0", Within => 2.0);
      Expect_Nothing_After (R, "M=0");
      R.Monitor.Connect (R.Supervisor.Port);
      Expect_Initial_State (R);
      R.Monitor.Expect_Silence ("MEND MPRG MSSG", For_Time => 1.2);
      Refuse (R, Far, "robot not started");
   end Ended_By_Lost_Monitor;

   procedure Ended_By_Stalled_Camera is

      procedure Measure;

      procedure Measure is
         R       : Rig;
         Stalled : Instant;
         Stop    : Emulators.Note;
      begin
         Prepare (R);
         Begin_Drive (R);
         R.Emulator.Clear_Journal;
         R.Emulator.Tell ("camera stall");
         Stalled := Now;
         Expect_End (R, "aborted;no image for 300 ms");
         Stop := R.Emulator.Await_On_Wire ("M=0", Within => 1.0);
         Expect_Nothing_After (R, "M=0");
         Note ("stopped " & Milliseconds (Stop.Last - Stalled)
               & " after the camera");
         Check_Within (Stop.Last - Stalled, Stop_Limit, "the stop");
      end Measure;

   begin
      Measure_Calmly (Measure'Access);
   end Ended_By_Stalled_Camera;

   procedure Ended_By_Robot_Out_Of_Sight is
      R : Rig;
   begin
      Prepare (R);
      Begin_Drive (R);
      R.Emulator.Tell ("camera size 64x48");
      Expect_End (R, "aborted;robot not seen in 3 images");
      Expect_Nothing_After (R, "M=0");
   end Ended_By_Robot_Out_Of_Sight;

   procedure Ended_By_Positions_Off is
      R : Rig;
   begin
      Prepare (R);
      Begin_Drive (R);
      R.Monitor.Expect ("CPST", "AACK");
      Expect_End (R, "aborted;camera, positions or arena given up");
      Expect_Nothing_After (R, "M=0");
   end Ended_By_Positions_Off;

   procedure Ended_By_Lost_Robot is
      R : Rig;
   begin
      Prepare (R);
      Begin_Drive (R);
      R.Emulator.Tell ("silent on");
      Expect_End (R, "aborted;robot lost or no longer started");
   end Ended_By_Lost_Robot;

   procedure Ended_By_Reset_Robot is
      R : Rig;
   begin
      Prepare (R, Watchdog => True);
      Begin_Drive (R);
      R.Emulator.Tell ("reset-robot");
      declare
         Item : constant Message := R.Monitor.Next_Of ("MEND", Within => 3.0);
      begin
         Note ("ends " & To_String (Item.Data));
         Check (Head (To_String (Item.Data), 8) = "aborted;",
                "ends " & To_String (Item.Data));
      end;
      R.Monitor.Expect_Silence ("MEND MPRG", For_Time => 1.5);
   end Ended_By_Reset_Robot;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add (Suite, "Mission_Path_Is_Driven", Path_Is_Driven'Access);
      Add (Suite, "Mission_To_A_Point_In_The_Image",
           Point_In_The_Image'Access);
      Add (Suite, "Mission_Refused_With_Reason", Refused_With_Reason'Access);
      Add (Suite, "Mission_Refused_As_Arena_Too_Small",
           Refused_As_Arena_Too_Small'Access);
      Add (Suite, "Mission_Malformed_Paths", Malformed_Paths'Access);
      Add (Suite, "Mission_One_At_A_Time", One_At_A_Time'Access);
      Add (Suite, "Mission_Ended_By_Hand", Ended_By_Hand'Access);
      Add (Suite, "Mission_Ended_By_Abort", Ended_By_Abort'Access);
      Add (Suite, "Mission_Not_Ended_By_Questions",
           Not_Ended_By_Questions'Access);
      Add (Suite, "Mission_Ended_By_Lost_Monitor",
           Ended_By_Lost_Monitor'Access);
      Add (Suite, "Mission_Ended_By_Stalled_Camera",
           Ended_By_Stalled_Camera'Access);
      Add (Suite, "Mission_Ended_By_Robot_Out_Of_Sight",
           Ended_By_Robot_Out_Of_Sight'Access);
      Add (Suite, "Mission_Ended_By_Positions_Off",
           Ended_By_Positions_Off'Access);
      Add (Suite, "Mission_Ended_By_Lost_Robot", Ended_By_Lost_Robot'Access);
      Add (Suite, "Mission_Ended_By_Reset_Robot",
           Ended_By_Reset_Robot'Access);
   end Add_To;

end Mission_Tests;
