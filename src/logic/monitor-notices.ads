--  SPDX-License-Identifier: GPL-3.0-or-later
--  The text messages to the monitor (MSSG).

with Missions;
with Schedule;

package Monitor.Notices with SPARK_Mode is

   type Notice is
     (Robot_Not_Running,
      Camera_Silent,
      Camera_Ended,
      Needs_Started_Robot,     --  why a mission is not possible
      Needs_Open_Camera,
      Needs_Positions,
      Needs_Confirmed_Arena,
      Needs_Larger_Arena,
      Needs_Seen_Robot,
      Needs_Points_Inside)
   with Default_Value => Robot_Not_Running;

   Silence : constant String :=
     (Character'Val (48 + Schedule.Camera_Silence_Tenths / 10), '.',
      Character'Val (48 + Schedule.Camera_Silence_Tenths mod 10));
   --  In seconds

   No_Mission : constant String := "mission not possible: ";

   function Text_Of (Item : Notice) return String is
     (case Item is
         when Robot_Not_Running =>
            "robot no longer runs (watchdog or reset): start again",
         when Camera_Silent     =>
            "camera closed: it has delivered nothing for " & Silence & " s",
         when Camera_Ended      =>
            "camera closed: it delivers no images any more",
         when Needs_Started_Robot   => No_Mission & "robot not started",
         when Needs_Open_Camera     => No_Mission & "camera closed",
         when Needs_Positions       => No_Mission & "positions off",
         when Needs_Confirmed_Arena => No_Mission & "arena not confirmed",
         when Needs_Larger_Arena    =>
            No_Mission & "arena too small in the image",
         when Needs_Seen_Robot      =>
            No_Mission & "robot not seen, or more than one",
         when Needs_Points_Inside   =>
            No_Mission & "a point is outside the arena less its margin")
   with
     Post => Text_Of'Result'First = 1
       and then Text_Of'Result'Length in 1 .. 80
       and then (for all C of Text_Of'Result => C in ' ' .. '~');

   function Notice_Of (Why : Missions.Refusal) return Notice is
     (case Why is
         when Missions.Robot_Not_Started   => Needs_Started_Robot,
         when Missions.Camera_Closed       => Needs_Open_Camera,
         when Missions.Positions_Off       => Needs_Positions,
         when Missions.Arena_Not_Confirmed => Needs_Confirmed_Arena,
         when Missions.Arena_Too_Small     => Needs_Larger_Arena,
         when Missions.Robot_Not_Seen      => Needs_Seen_Robot,
         when Missions.Point_Outside       => Needs_Points_Inside);

end Monitor.Notices;
