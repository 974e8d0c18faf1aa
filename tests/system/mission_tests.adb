--  SPDX-License-Identifier: GPL-3.0-or-later
--  Missions: refused, driven, ended; and random ones, judged.

with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Child_Processes;       use Child_Processes;
with Emulators;
with Expectations;          use Expectations;
with Instants;              use Instants;
with Mission_Judges;        use Mission_Judges;
with Mission_Plans;         use Mission_Plans;
with Monitor_Clients;       use Monitor_Clients;
with Plain_Numbers;         use Plain_Numbers;
with Real_Missions;
with Rigs;                  use Rigs;
with Samples;
with Scenarios;             use Scenarios;

procedure Mission_Tests is

   Near  : constant String := "MPCM:52;38;28;38";
   Far   : constant String := "MGCM:68;48";
   --  From where the robot stands at first, the middle of the arena

   Not_Seen : constant String := "robot not seen, or more than one";

   No_Image : constant String := "aborted;no image for 300 ms";

   Stop_Limit : constant Duration := 0.4;
   --  without a position, until the robot is stopped

   function Off_By (X, Y, To_X, To_Y : Float) return Float is
     (Float'Max (abs (X - To_X), abs (Y - To_Y)));

   Confirmed : constant String :=
     Arena_Searched & ", send CACO, comes CIMG, comes CIMG, comes CIMG";

   Driving : constant String :=
     With_Positions & ", " & Confirmed & ", clear, " & Far
     & " AACK, status moving 1";
   --  A mission to Far is under way, if the robot is started

   procedure Refuse (R : in out Rig; Order, Reason : String) is
      Refused : constant String := "mission not possible: ";
      Seen    : Unbounded_String;
   begin
      for Attempt in 1 .. 20 loop
         R.Monitor.Expect (Order, "ANAK");
         Seen := R.Monitor.Next_Of ("MSSG").Data;
         --  it may not be seen for a moment
         exit when Seen /= Refused & Not_Seen;
      end loop;
      Check (Seen = Refused & Reason,
             Order & " is refused by " & To_String (Seen));
   end Refuse;

   procedure Expect_Last (R : in out Rig; Command : String) is
      Wire : constant String := R.Emulator.Wire_Text;
   begin
      Check (Tail (Wire, Command'Length + 1) = Command & " ",
             "the last order is not " & Command & ": " & Wire);
   end Expect_Last;

   procedure Check_End (End_Of : Message; Texts : String) is
      --  One of Texts, which '|' separates. A busy machine may delay images
      Seen     : constant String := To_String (End_Of.Data);
      Is_Right : constant Boolean :=
        (for some Text of Words (Texts, '|') => Seen = Text);
   begin
      Check_In_Time (Is_Right or else Seen /= No_Image, "ends " & Seen);
      Check (Is_Right, "ends " & Seen & ", not " & Texts);
   end Check_End;

   procedure Expect_End (R : in out Rig; Text : String; Last : String) is
      --  The one end of the one mission; the last order on the wire is Last,
      --  if that is known
   begin
      Check_End (R.Monitor.Next_Of ("MEND"), Text);
      R.Monitor.Expect_Silence ("MEND MPRG", For_Time => 0.7);
      Check (R.Monitor.Count_Of ("MEND") = 1, "more than one end");
      if Last /= "" then
         Expect_Last (R, Last);
      end if;
   end Expect_End;

   procedure Drive_To_End (R : in out Rig; Order : String) is
   begin
      R.Monitor.Expect (Order, "AACK");
      Check_End (R.Monitor.Next_Of ("MEND"), "done");
   end Drive_To_End;

   procedure Path_Is_Driven (R : in out Rig) is
      Item     : Message;
      Leg      : Natural := 0;
      Reported : Natural := 0;
   begin
      R.Monitor.Skip_To_Now;
      R.Monitor.Expect (Near, "AACK");
      loop
         Item := R.Monitor.Next_Of ("MPRG MEND");
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
      Check_End (Item, "done");
      Check (Leg = 2 and then Reported >= 2, "progress not told");
      declare
         Now : constant Emulators.Truth := R.Emulator.Pose;
      begin
         Note ("off by " & Off_By (Now.X, Now.Y, 28.0, 38.0)'Image & " cm");
         Check (Off_By (Now.X, Now.Y, 28.0, 38.0) <= 1.5,
                "the robot is elsewhere");
      end;
      Expect_Last (R, "M=0");

      --  and the next at once, to a point in the image

      Drive_To_End (R, "MGTO:250.5;180");
      declare
         Now : constant Emulators.Truth := R.Emulator.Pose;
      begin
         Note ("off by " & Off_By (Now.Cx, Now.Cy, 250.5, 180.0)'Image
               & " px");
         Check (Off_By (Now.Cx, Now.Cy, 250.5, 180.0) <= 10.0,
                "the robot is elsewhere");
      end;
      Check (R.Emulator.Status ("disabled_count") = "0",
             "the watchdog has ended the run");
   end Path_Is_Driven;

   procedure Refused_With_Reason (R : in out Rig) is
   begin
      Refuse (R, "MPTH:" & 63 * "1;2;" & "1;2", "robot not started");
      Play (R, "ROPN AACK");
      Refuse (R, Far, "robot not started");
      Play (R, "RSOW AACK");
      Refuse (R, Far, "camera closed");
      Play (R, With_Images);
      Refuse (R, Far, "positions off");
      Play (R, "CPCO AACK, comes CPOS");
      Refuse (R, Far, "arena not confirmed");
      Refuse (R, "MGTO:320;240", "arena not confirmed");
      Play (R, Confirmed);
      for Order of Words
        ("MGCM:7;30 MGCM:73;30 MGCM:40;-3 MGCM:40;9999999 MGTO:0;0"
         & " MPTH:320;240;-99999;240")
      loop
         Refuse (R, Order, "a point is outside the arena less its margin");
      end loop;
      Play (R, "tell camera stall, wait 1.0");
      Refuse (R, Far, Not_Seen);
      Play (R, "tell camera on, comes CPOS, silence 0.3 MEND MPRG, wire");
   end Refused_With_Reason;

   procedure Refused_As_Arena_Too_Small (R : in out Rig) is
   begin
      Refuse (R, Far, "arena too small in the image");
   end Refused_As_Arena_Too_Small;

   procedure One_At_A_Time (R : in out Rig) is
   begin
      Expect_End (R, "done", Last => "M=0");
   end One_At_A_Time;

   procedure Add_Ended
     (By, Cause, Ending : String;
      Last              : String  := "M=0";
      Beginning         : String  := Started)
   is
      --  By Cause, a script, while it drives

      procedure Run (R : in out Rig) is
      begin
         Expect_End (R, "aborted;" & Ending, Last);
      end Run;

   begin
      Script ("Mission_Ended_By_" & By,
              Beginning & ", " & Driving & ", " & Cause, Run'Access,
              Camera => True, Timed => True);
   end Add_Ended;

   procedure Far_From_Ideal (R : in out Rig) is

      procedure Try (Wheels, Order, Texts : String) is
         --  The robot rests where it may be
         Place : Emulators.Truth;
      begin
         Play (R, "tell turn-speed 100, tell speed 100, tell " & Wheels
               & ", tell pose 20 20 0, comes CPOS, comes CPOS, "
               & Order & " AACK");
         Check_End (R.Monitor.Next_Of ("MEND"), Texts);
         Place := R.Emulator.Pose;
         Check (Place.X in 7.0 .. 73.0 and then Place.Y in 7.0 .. 53.0,
                "it is outside");
      end Try;

   begin
      Try ("turn-speed 10", "MGCM:20;50",
           "aborted;robot turns 9 % of what is asked"
           & "|aborted;robot turns 10 % of what is asked"
           & "|aborted;robot turns 11 % of what is asked");
      Try ("speed 3", "MGCM:60;20",
           "aborted;robot drives 2 % of what is asked"
           & "|aborted;robot drives 3 % of what is asked"
           & "|aborted;robot drives 4 % of what is asked");
      Try ("turn-speed 180, tell speed 180", "MPCM:60;50;70;20", "done");
   end Far_From_Ideal;

   procedure Ended_By_Abort (R : in out Rig) is
   begin
      Expect_End (R, "aborted;order by hand", Last => "M=0");

      --  without one it stops the robot just so, and then another may begin

      Play (R, "status moving 0, RGLF AACK, MABT AACK, status moving 0");
      Drive_To_End (R, "MGCM:40;30");
   end Ended_By_Abort;

   procedure Ended_By_Lost_Monitor (R : in out Rig) is
   begin
      Expect_Last (R, "M=0");
      Refuse (R, Far, "robot not started");
   end Ended_By_Lost_Monitor;

   procedure Ended_By_Stalled_Camera (R : in out Rig) is
      Stalled : Instant;
      Taken   : Samples.Set;
   begin
      for Attempt in 1 .. 3 loop
         Play (R, Far & " AACK, status moving 1, clear, tell camera stall");
         Stalled := Now;
         Check_End (R.Monitor.Next_Of ("MEND"), No_Image);
         Taken.Add (R.Emulator.Await_On_Wire ("M=0").Last - Stalled);
         Note ("stopped after " & Milliseconds (Taken.Last));
         Play (R, "tell pose 40 30 0, tell camera on, comes CPOS");
      end loop;
      Check_Within (Taken.Quantile (0.5), Stop_Limit, "the stop");
   end Ended_By_Stalled_Camera;

   Seed : constant := 1;
   --  The same missions each time, some of script/bench missions: those that
   --  take the least time of the first thirty

   procedure Try_Random (Number : Positive; Radio : Boolean := False) is
      --  Raises Failed unless it is done and reaches the goals, at once or in
      --  two of three runs: an image that a busy machine delays aborts it
      Name    : constant String := "mission " & Image (Number);
      Done    : Natural := 0;
      Aborted : Natural := 0;
      P       : Plan := Random (Seed, Number);
      V       : Verdict;
   begin
      P.Radio := Radio;
      loop
         Real_Missions.Run (P, V);
         Note (Name & ": " & Rounded (Float (V.Pass), 1)
               & " mm from a point at most, "
               & Rounded (Float (Ratio (V))) & " times an exact robot's time, "
               & Rounded (Float (V.Blind) * 1_000.0, 0)
               & " ms without a new position " & To_String (V.Reason));
         Check (V.Wrong = "", Name & ": " & To_String (V.Wrong));
         --  the goal of script/bench missions, and a margin for a machine that
         --  does other things, too
         Check_In_Time (not V.Done or else Ratio (V) <= 1.5 * Slowest,
                        Name & " takes " & Rounded (Float (Ratio (V)))
                        & " times an exact robot's time");
         Done := Done + Boolean'Pos (V.Done);
         Aborted := Aborted + Boolean'Pos (not V.Done);
         Check_In_Time
           (Aborted < 2, Name & " is aborted: " & To_String (V.Reason));
         exit when Done > Aborted;
      end loop;
   end Try_Random;

   procedure Add_Trial
     (Name : String; First, Second : Positive; Radio : Boolean := False)
   is

      procedure Run is
      begin
         Try_Random (First, Radio);
         Try_Random (Second, Radio);
      end Run;

   begin
      Add ("Mission_Trial_" & Name, Run'Access, Timed => True);
   end Add_Trial;

begin
   Script ("Mission_Refused_With_Reason", "MABT ANAK",
           Refused_With_Reason'Access, Camera => True);
   Script ("Mission_Refused_As_Arena_Too_Small",
           Started & ", " & With_Positions & ", " & Confirmed,
           Refused_As_Arena_Too_Small'Access, Camera => True,
           Emulator_Options   => "--frame-size 160x120 --noise 0",
           Supervisor_Options => "--frame-size 160x120");
   --  300 ms without an image end a mission that is under way
   Script ("Mission_Path_Is_Driven",
           Guarded & ", " & With_Positions & ", " & Confirmed & ", clear",
           Path_Is_Driven'Access, Camera => True, Timed => True);
   Script ("Mission_One_At_A_Time",
           Started & ", " & Driving & ", " & Far & " ACRJ, MPTH:320;240 ACRJ,"
           & " RPIN AACK, RGBT RBLV, RGST RCST", One_At_A_Time'Access,
           Camera => True, Timed => True);
   --  And questions do not end it
   Add_Ended ("Stop", "RSTP AACK", "order by hand");
   Add_Ended
     ("Drive_By_Hand", "RGFW AACK", "order by hand", Last => "M=32767");
   Add_Ended ("Turn_By_Hand", "RTRN:15 AACK", "order by hand", Last => "T=15");
   Add_Ended ("Closed_Line", "RCLS AACK", "order by hand");
   Script ("Mission_Of_Robot_Far_From_Ideal",
           Started & ", " & With_Positions & ", " & Confirmed,
           Far_From_Ideal'Access, Camera => True, Timed => True);
   Script ("Mission_Ended_By_Abort",
           Started & ", " & Driving & ", MABT AACK", Ended_By_Abort'Access,
           Camera => True, Timed => True);
   Script ("Mission_Ended_By_Lost_Monitor",
           Started & ", " & Driving & ", reset, status moving 0, connect, "
           & Initial & ", silence 1 MEND MPRG MSSG",
           Ended_By_Lost_Monitor'Access, Camera => True, Timed => True);
   Script ("Mission_Ended_By_Stalled_Camera",
           Started & ", " & With_Positions & ", " & Confirmed,
           Ended_By_Stalled_Camera'Access, Camera => True, Timed => True);
   Add_Ended ("Robot_Out_Of_Sight", "tell camera size 64x48",
              "robot not seen in 3 images");
   Add_Ended ("Positions_Off", "CPST AACK",
              "camera, positions or arena given up");
   Add_Ended ("Lost_Robot", "tell silent on",
              "robot lost or no longer started", Last => "");
   Add_Ended ("Reset_Robot", "tell reset-robot",
              "robot lost or no longer started"
              & "|aborted;robot refuses its orders",
              Last => "", Beginning => Guarded);
   --  As it is a ping or an order of the mission that the robot refuses first
   Add_Trial ("Ideal", 1, 3);
   Add_Trial ("By_Radio", 1, 18, Radio => True);
   Add_Trial ("With_Faults", 18, 30);
end Mission_Tests;
