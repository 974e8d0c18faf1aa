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

end Monitor.Notices;
