--  SPDX-License-Identifier: GPL-3.0-or-later
--  The event "the camera is open", for the periodic images.

package Vision.Camera_Events with SPARK_Mode is

   procedure Opened with Annotate => (GNATprove, Terminating);

   procedure Wait_Opened;
   --  For th_captureImg only

end Vision.Camera_Events;
