--  SPDX-License-Identifier: GPL-3.0-or-later
--  The messages to the monitor that nobody has asked for: texts (MSSG), and
--  the progress and end of a mission (MPRG, MEND).

with Missions;         use Missions;
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

   function Notice_Of (Why : Refusal) return Notice is
     (case Why is
         when Robot_Not_Started   => Needs_Started_Robot,
         when Camera_Closed       => Needs_Open_Camera,
         when Positions_Off       => Needs_Positions,
         when Arena_Not_Confirmed => Needs_Confirmed_Arena,
         when Arena_Too_Small     => Needs_Larger_Arena,
         when Robot_Not_Seen      => Needs_Seen_Robot,
         when Point_Outside       => Needs_Points_Inside);

   --  Missions

   subtype Millimetres is Natural range 0 .. 9_999_999;

   Max_Text : constant := 48;
   --  Characters of an end's text, at most

   function Image (Value : Percent) return String
   with
     Post => Image'Result'First = 1
       and then Image'Result'Length in 1 .. 3
       and then (for all C of Image'Result => C in '0' .. '9');

   function Text_Of (Why : Ending; Measured : Percent := 0) return String is
     (case Why is
         when Completed        => "done",
         when By_Hand          => "aborted;order by hand",
         when Session_Over     => "aborted;monitor lost",
         when Robot_Stopped    => "aborted;robot lost or no longer started",
         when Camera_Ended     =>
            "aborted;camera, positions or arena given up",
         when No_Position      => "aborted;robot not seen in 3 images",
         when No_Image         => "aborted;no image for 300 ms",
         when No_Progress      => "aborted;no progress for 2 s",
         when Leg_Too_Long     => "aborted;leg takes longer than its time",
         when Orders_Refused   => "aborted;robot refuses its orders",
         when Turns_Amiss      =>
            "aborted;robot turns " & Image (Measured) & " % of what is asked",
         when Drives_Amiss     =>
            "aborted;robot drives " & Image (Measured) & " % of what is asked",
         when No_Way           => "aborted;no permitted way")
   with
     Post => Text_Of'Result'First = 1
       and then Text_Of'Result'Length in 4 .. Max_Text
       and then (for all C of Text_Of'Result => C in ' ' .. '~');

   function Progress_Line
     (Leg, Of_Legs : Point_Number; Distance : Millimetres) return Short_Text;
   --  MPRG:leg;of;distance; the distance to the leg's point

   function End_Line (Why : Ending; Measured : Percent) return Short_Text is
     (Short (End_Label & Separator & Text_Of (Why, Measured)));
   --  MEND:text

end Monitor.Notices;
