--  SPDX-License-Identifier: GPL-3.0-or-later
--  The lines on a mission: progress, every end, every refusal.

with Missions;         use Missions;
with Monitor.Notices;  use Monitor.Notices;
with Monitor.Protocol; use Monitor.Protocol;
with Unit_Runs; use Unit_Runs;

procedure Missions_Texts_Tests is

   function Text_Of (Line : Short_Text) return String is
     (Line.Data (1 .. Line.Length));

   function End_Line (Why : Ending; Measured : Percent) return String is
     (Text_Of (Monitor.Notices.End_Line (Why, Measured)));

   function Progress
     (Leg, Of_Legs : Point_Number; Distance : Millimetres)
     return String
   is (Text_Of (Progress_Line (Leg, Of_Legs, Distance)));

   procedure Test_Ends is

      Count : Natural := 0;

      procedure Check
        (Why : Ending; Expected : String; Measured : Percent := 0) is
      begin
         Count := Count + 1;
         Assert (End_Line (Why, Measured) = "MEND:" & Expected & Line_Feed,
                 Expected);
      end Check;

   begin
      Check (Completed, "done");
      Check (By_Hand, "aborted;order by hand");
      Check (Session_Over, "aborted;monitor lost");
      Check (Robot_Stopped, "aborted;robot lost or no longer started");
      Check (Missions.Camera_Ended,
             "aborted;camera, positions or arena given up");
      Check (No_Position, "aborted;robot not seen in 3 images");
      Check (No_Image, "aborted;no image for 300 ms");
      Check (No_Progress, "aborted;no progress for 2 s");
      Check (Leg_Too_Long, "aborted;leg takes longer than its time");
      Check (Orders_Refused, "aborted;robot refuses its orders");
      Check (Turns_Amiss, "aborted;robot turns 8 % of what is asked", 8);
      Check (Drives_Amiss, "aborted;robot drives 210 % of what is asked", 210);
      Check (No_Way, "aborted;no permitted way");
      Assert (Count = Ending'Pos (Ending'Last) + 1, "all of them");
   end Test_Ends;

   procedure Test_Progress is
   begin
      Assert (Progress (1, 1, 0) = "MPRG:1;1;0" & Line_Feed, "the least");
      Assert (Progress (3, 12, 457) = "MPRG:3;12;457" & Line_Feed, "some");
      Assert (Progress (64, 64, Millimetres'Last)
              = "MPRG:64;64;9999999" & Line_Feed, "the largest");
   end Test_Progress;

   procedure Test_Refusals is

      Count : Natural := 0;

      procedure Check (Why : Refusal; Reason : String) is
      begin
         Count := Count + 1;
         Assert (String'(Text_Of (Why)) = "mission not possible: " & Reason,
                 Reason);
      end Check;

   begin
      Check (Robot_Not_Started, "robot not started");
      Check (Camera_Closed, "camera closed");
      Check (Positions_Off, "positions off");
      Check (Arena_Not_Confirmed, "arena not confirmed");
      Check (Arena_Too_Small, "arena too small in the image");
      Check (Robot_Not_Seen, "robot not seen, or more than one");
      Check (Point_Outside, "a point is outside the arena less its margin");
      Assert (Count = Refusal'Pos (Refusal'Last) + 1, "all of them");
   end Test_Refusals;

begin
   Run_Test ("progress", Test_Progress'Access);
   Run_Test ("ends", Test_Ends'Access);
   Run_Test ("refusals", Test_Refusals'Access);
end Missions_Texts_Tests;
