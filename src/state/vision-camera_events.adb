--  SPDX-License-Identifier: GPL-3.0-or-later
--  The event "the camera is open", for the periodic images.

with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with Schedule;
with Trace;

package body Vision.Camera_Events with SPARK_Mode is

   Images_Begin : Suspension_Object;

   procedure Opened is
   begin
      Trace.Release (Schedule.Th_Capture_Img);
      Set_True (Images_Begin);
   end Opened;

   procedure Wait_Opened is
   begin
      Trace.Done (Schedule.Th_Capture_Img);
      Suspend_Until_True (Images_Begin);
   end Wait_Opened;

end Vision.Camera_Events;
