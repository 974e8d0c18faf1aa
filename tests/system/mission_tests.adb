--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Child_Processes;       use Child_Processes;
with Dialogues;             use Dialogues;
with Emulators;
with Expectations;          use Expectations;
with Instants;              use Instants;
with Monitor_Clients;       use Monitor_Clients;
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

   procedure Confirm_Arena (R : in out Rig) is
   begin
      Search_Arena (R);
      R.Monitor.Send_Line ("CACO");
      R.Monitor.Await ("CIMG", Count => 3);
   end Confirm_Arena;

   procedure Prepare (R : in out Rig; Watchdog : Boolean := False) is
      --  All that a mission needs
   begin
      Assemble (R, Camera => True);
      Start_Robot (R, Watchdog);
      Open_Camera (R, Positions => True);
      Confirm_Arena (R);
      R.Emulator.Clear_Journal;
   end Prepare;

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

   procedure Begin_Drive (R : in out Rig) is
      --  A mission to Far is under way, and the robot moves
   begin
      R.Monitor.Expect (Far, "AACK");
      R.Emulator.Await_Status ("moving", "1");
   end Begin_Drive;

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

   procedure Refused_With_Reason is
      R : Rig;
   begin
      Assemble (R, Camera => True);
      R.Monitor.Expect ("MABT", "ANAK");
      Refuse (R, "MPTH:" & 63 * "1;2;" & "1;2", "robot not started");
      R.Monitor.Expect ("ROPN", "AACK");
      Refuse (R, Far, "robot not started");
      R.Monitor.Expect ("RSOW", "AACK");
      Refuse (R, Far, "camera closed");
      Open_Camera (R);
      Refuse (R, Far, "positions off");
      Play (R, "CPCO AACK, comes CPOS");
      Refuse (R, Far, "arena not confirmed");
      Refuse (R, "MGTO:320;240", "arena not confirmed");
      Confirm_Arena (R);
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

   procedure Refused_As_Arena_Too_Small is
      R : Rig;
   begin
      Assemble (R, Camera          => True,
                Emulator_Options   => "--frame-size 160x120 --noise 0",
                Supervisor_Options => "--frame-size 160x120");
      Start_Robot (R);
      Open_Camera (R, Positions => True);
      Confirm_Arena (R);
      Refuse (R, Far, "arena too small in the image");
   end Refused_As_Arena_Too_Small;

   procedure One_At_A_Time is
      --  and questions do not end it
      R : Rig;
   begin
      Prepare (R);
      Begin_Drive (R);
      Play (R, Far & " ACRJ, MPTH:320;240 ACRJ, RPIN AACK, RGBT RBLV,"
            & " RGST RCST");
      Expect_End (R, "done", Last => "M=0");
   end One_At_A_Time;

   procedure Add_Ended
     (By, Cause, Ending : String;
      Last              : String  := "M=0";
      Watchdog          : Boolean := False)
   is
      --  By Cause, a script, while it drives

      procedure Run is
         R : Rig;
      begin
         Prepare (R, Watchdog);
         Begin_Drive (R);
         Play (R, Cause);
         Expect_End (R, "aborted;" & Ending, Last);
      end Run;

   begin
      Add ("Mission_Ended_By_" & By, Run'Access, Timed => True);
   end Add_Ended;

   procedure Far_From_Ideal is
      R : Rig;

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
      Prepare (R);
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

   procedure Ended_By_Abort is
      R : Rig;
   begin
      Prepare (R);
      Begin_Drive (R);
      R.Monitor.Expect ("MABT", "AACK");
      Expect_End (R, "aborted;order by hand", Last => "M=0");
      Play (R, "status moving 0");

      --  without one it stops the robot just so, and then another may begin

      Play (R, "RGLF AACK, MABT AACK, status moving 0");
      Drive_To_End (R, "MGCM:40;30");
   end Ended_By_Abort;

   procedure Ended_By_Lost_Monitor is
      R : Rig;
   begin
      Prepare (R);
      Begin_Drive (R);
      R.Monitor.Reset;
      R.Emulator.Await_Status ("moving", "0");
      Connect (R);
      Expect_Initial_State (R);
      R.Monitor.Expect_Silence ("MEND MPRG MSSG", For_Time => 1.0);
      Expect_Last (R, "M=0");
      Refuse (R, Far, "robot not started");
   end Ended_By_Lost_Monitor;

   procedure Ended_By_Stalled_Camera is
      R       : Rig;
      Stalled : Instant;
      Taken   : Samples.Set;
   begin
      Prepare (R);
      for Attempt in 1 .. 3 loop
         Begin_Drive (R);
         R.Emulator.Clear_Journal;
         R.Emulator.Tell ("camera stall");
         Stalled := Now;
         Check_End (R.Monitor.Next_Of ("MEND"), No_Image);
         Taken.Add (R.Emulator.Await_On_Wire ("M=0").Last - Stalled);
         Note ("stopped after " & Milliseconds (Taken.Last));
         Play (R, "tell pose 40 30 0, tell camera on, comes CPOS");
      end loop;
      Check_Within (Taken.Quantile (0.5), Stop_Limit, "the stop");
   end Ended_By_Stalled_Camera;

begin
   Add ("Mission_Refused_With_Reason", Refused_With_Reason'Access);
   Add ("Mission_Refused_As_Arena_Too_Small",
        Refused_As_Arena_Too_Small'Access);
   --  300 ms without an image end a mission that is under way
   Add ("Mission_Path_Is_Driven", Path_Is_Driven'Access, Timed => True);
   Add ("Mission_One_At_A_Time", One_At_A_Time'Access, Timed => True);
   Add_Ended ("Stop", "RSTP AACK", "order by hand");
   Add_Ended
     ("Drive_By_Hand", "RGFW AACK", "order by hand", Last => "M=32767");
   Add_Ended ("Turn_By_Hand", "RTRN:15 AACK", "order by hand", Last => "T=15");
   Add_Ended ("Closed_Line", "RCLS AACK", "order by hand");
   Add ("Mission_Of_Robot_Far_From_Ideal",
        Far_From_Ideal'Access, Timed => True);
   Add ("Mission_Ended_By_Abort", Ended_By_Abort'Access, Timed => True);
   Add ("Mission_Ended_By_Lost_Monitor",
        Ended_By_Lost_Monitor'Access, Timed => True);
   Add ("Mission_Ended_By_Stalled_Camera",
        Ended_By_Stalled_Camera'Access, Timed => True);
   Add_Ended ("Robot_Out_Of_Sight", "tell camera size 64x48",
              "robot not seen in 3 images");
   Add_Ended ("Positions_Off", "CPST AACK",
              "camera, positions or arena given up");
   Add_Ended ("Lost_Robot", "tell silent on",
              "robot lost or no longer started", Last => "");
   Add_Ended ("Reset_Robot", "tell reset-robot",
              "robot lost or no longer started"
              & "|aborted;robot refuses its orders",
              Last => "", Watchdog => True);
   --  As it is a ping or an order of the mission that the robot refuses first
end Mission_Tests;
