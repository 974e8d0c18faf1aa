--  SPDX-License-Identifier: GPL-3.0-or-later
--  The lines on a mission to the monitor: its progress (MPRG) and end (MEND).

with Monitor.Protocol; use Monitor.Protocol;

package Missions.Texts with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Missions.Texts);

   subtype Millimetres is Natural range 0 .. 9_999_999;

   Max_Text : constant := 48;
   --  Characters of an end's text, at most

   function Digit (Value : Natural) return Character is
     (Character'Val (Character'Pos ('0') + Value))
   with Pre => Value <= 9;

   function Image (Value : Percent) return String is
     ((if Value < 10 then ""
       elsif Value < 100 then (1 => Digit (Value / 10))
       else Digit (Value / 100) & Digit (Value / 10 mod 10))
      & Digit (Value mod 10))
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
         when Watchdog_Trouble => "aborted;watchdog reload refused",
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

   procedure Format_Progress
     (Leg, Of_Legs : Point_Number;
      Distance     : Millimetres;
      Line         : out Short_Line;
      Last         : out Natural)
   with
     Post => Last in 11 .. 32
       and then Begins_With (Line, Progress_Label)
       and then Line (5) = Separator
       and then Line (Last) = Line_Feed
       and then (for all I in 6 .. Last - 1 =>
                   Line (I) in '0' .. '9' | Field_Separator);
   --  MPRG:leg;of;distance and a line feed in Line (1 .. Last); the distance
   --  to the leg's point

   procedure Format_End
     (Why      : Ending;
      Measured : Percent;
      Line     : out Short_Line;
      Last     : out Natural)
   with
     Post => Last = Text_Of (Why, Measured)'Length + 6
       and then Begins_With (Line, End_Label)
       and then Line (5) = Separator
       and then Line (6 .. Last - 1) = Text_Of (Why, Measured)
       and then Line (Last) = Line_Feed;
   --  MEND:text and a line feed in Line (1 .. Last)

end Missions.Texts;
