--  SPDX-License-Identifier: GPL-3.0-or-later

with Event;
with Schedule;
with Trace;

package body Vision.Camera_Events with SPARK_Mode is

   package Images_Begin is new Event;

   procedure Opened is
   begin
      Trace.Release (Schedule.Th_Capture_Img);
      Images_Begin.Set;
   end Opened;

   procedure Wait_Opened is
   begin
      Trace.Done (Schedule.Th_Capture_Img);
      Images_Begin.Wait;
   end Wait_Opened;

end Vision.Camera_Events;
