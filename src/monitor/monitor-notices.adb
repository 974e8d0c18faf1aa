--  SPDX-License-Identifier: GPL-3.0-or-later

with Schedule;

package body Monitor.Notices with SPARK_Mode is

   Silence : constant String :=
     (Character'Val (48 + Schedule.Camera_Silence_Tenths / 10), '.',
      Character'Val (48 + Schedule.Camera_Silence_Tenths mod 10));
   --  In seconds

   No_Mission : constant String := "mission not possible: ";

   function Text_Of (Item : Notice) return String is
     (case Item is
         when Robot_Not_Running =>
            "robot no longer runs (watchdog or reset): reset and "
            & "start again",
         when Robot_Lost_Empty  =>
            "robot lost: its battery was empty, it may be off: charge it",
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
            No_Mission & "a point is outside the arena less its margin");

   function Image (Value : Percent) return String is
      Line : Short_Text;
   begin
      Numbers.Append (Value, 1, Line.Data, Line.Length);
      return Line.Data (1 .. Line.Length);
   end Image;

   function Progress_Line
     (Leg, Of_Legs : Point_Number; Distance : Millimetres) return Short_Text
   is
      Line : Short_Text;
   begin
      Append (Line, Progress_Label & Separator);
      Append_Number (Line, Leg);
      Append (Line, (1 => Field_Separator));
      Append_Number (Line, Of_Legs);
      Append (Line, (1 => Field_Separator));
      Append_Number (Line, Distance);
      Append (Line, (1 => Line_Feed));
      return Line;
   end Progress_Line;

end Monitor.Notices;
