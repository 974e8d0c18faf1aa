--  SPDX-License-Identifier: GPL-3.0-or-later
--  The text messages to the monitor (MSSG).

with Missions;
with Monitor.Protocol; use Monitor.Protocol;

package Monitor.Notices with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Monitor.Notices);

   type Notice is
     (Robot_Not_Running,
      Robot_Lost_Empty,        --  its battery
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

   function Text_Of (Item : Notice) return String
   with
     Post => Text_Of'Result'First = 1
       and then Text_Of'Result'Length in 1 .. 80
       and then (for all C of Text_Of'Result => C in ' ' .. '~');

   function Line_Of (Item : Notice) return Short_Text is
     (Short (Log_Label & Separator & Text_Of (Item)));

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
