--  SPDX-License-Identifier: GPL-3.0-or-later
--  The messages to the monitor that are no plain replies: texts (MSSG), the
--  progress and end of a mission (MPRG, MEND), the robot's position (CPOS) and
--  the arena's ground (CARN).

with Missions;         use Missions;
with Monitor.Protocol; use Monitor.Protocol;
with Schedule;

package Monitor.Notices with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Monitor.Notices);  --  proved

   function Text_Of (Why : Refusal) return String is
     ("mission not possible: "
      & (case Why is
            when Robot_Not_Started   => "robot not started",
            when Camera_Closed       => "camera closed",
            when Positions_Off       => "positions off",
            when Arena_Not_Confirmed => "arena not confirmed",
            when Arena_Too_Small     => "arena too small in the image",
            when Robot_Not_Seen      => "robot not seen, or more than one",
            when Point_Outside       =>
               "a point is outside the arena less its margin"))
   with
     Post => Text_Of'Result'First = 1
       and then Text_Of'Result'Length in 1 .. 80;

   Robot_Not_Running : constant String :=
     "robot no longer runs (watchdog or reset): reset and start again";

   Robot_Lost_Empty : constant String :=
     "robot lost: its battery was empty, it may be off: charge it";

   Camera_Silent : constant String :=
     "camera closed: it has delivered nothing for "
     & (Character'Val (48 + Schedule.Camera_Silence_Tenths / 10), '.',
        Character'Val (48 + Schedule.Camera_Silence_Tenths mod 10)) & " s";

   Camera_Stopped : constant String :=
     "camera closed: it delivers no images any more";

   --  Missions

   subtype Millimetres is Natural range 0 .. 9_999_999;

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
       and then Text_Of'Result'Length in 4 .. 48
       and then (for all C of Text_Of'Result => C in ' ' .. '~');

   function Progress_Line
     (Leg, Of_Legs : Point_Number; Distance : Millimetres) return Short_Text;
   --  MPRG:leg;of;distance; the distance to the leg's point

   function End_Line (Why : Ending; Measured : Percent) return Short_Text is
     (Short (End_Label & Separator & Text_Of (Why, Measured)));
   --  MEND:text

   --  Positions

   type Micro is range -10 ** 13 .. 10 ** 13;
   --  Millionths: of a pixel, or of a degree

   subtype Robot_Id is Integer range -1 .. 999;
   --  The number of a marker; -1 without a robot

   type Position is record
      Id     : Robot_Id := -1;
      Angle  : Micro    := 0;
      Cx, Cy : Micro    := 0;
      Dx, Dy : Micro    := 0;
   end record;
   --  Angle in degrees; centre (Cx, Cy) and direction (Dx, Dy) in pixels of
   --  the whole image

   Not_Found : constant Position :=
     (Id => -1, Angle => 0, Cx => -1_000_000, Cy => -1_000_000,
      Dx => 0, Dy => 0);
   --  No robot in the image: F18 requires identifier and centre; angle and
   --  direction are 0 as in the empty position of the existing platform

   function Position_Line (P : Position) return Short_Text;
   --  CPOS:id;angle;cx;cy;dx;dy and a line feed: the id as an integer, the
   --  others with exactly six decimals

   subtype Coordinate is Micro range -999_999_999 .. 9_999_999_999;
   --  In every image

   type Corners is array (1 .. 8) of Coordinate;
   --  x and y of an arena's corners, clockwise from the upper left one

   function Ground
     (Size   : Arena_Size;
      Margin : Natural;
      Where  : Corners) return Short_Text
   with Pre => Margin <= 9;
   --  CARN:width;height;margin;x;y;x;y;x;y;x;y and a line feed: centimetres,
   --  then pixels with exactly six decimals. A mission's points keep Margin
   --  from the border

end Monitor.Notices;
