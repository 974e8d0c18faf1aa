--  SPDX-License-Identifier: GPL-3.0-or-later
--  The text messages to the monitor (MSSG).

with Schedule;

package Monitor.Notices with SPARK_Mode is

   type Notice is
     (Robot_Not_Running,
      Camera_Silent,
      Camera_Ended)
   with Default_Value => Robot_Not_Running;

   Silence : constant String :=
     (Character'Val (48 + Schedule.Camera_Silence_Tenths / 10), '.',
      Character'Val (48 + Schedule.Camera_Silence_Tenths mod 10));
   --  In seconds

   function Text_Of (Item : Notice) return String is
     (case Item is
         when Robot_Not_Running =>
            "robot no longer runs (watchdog or reset): start again",
         when Camera_Silent     =>
            "camera closed: it has delivered nothing for " & Silence & " s",
         when Camera_Ended      =>
            "camera closed: it delivers no images any more")
   with
     Post => Text_Of'Result'First = 1
       and then Text_Of'Result'Length in 1 .. 80
       and then (for all C of Text_Of'Result => C in ' ' .. '~');

end Monitor.Notices;
