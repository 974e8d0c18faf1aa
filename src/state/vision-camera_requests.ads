--  SPDX-License-Identifier: GPL-3.0-or-later
--  Requests to the camera's owner: open, close. Only th_cameraControl waits
--  for a camera that is slow to open, which may then no longer be needed.

package Vision.Camera_Requests with SPARK_Mode is

   type Request_Number is mod 2 ** 32;

   procedure Open (Success : out Boolean);
   --  Requests the camera and waits for the outcome. For th_cameraControl only

   procedure Close with Annotate => (GNATprove, Terminating);
   --  The camera is no longer requested. Does not wait

   procedure Get_Idle (Idle : out Boolean)
   with Annotate => (GNATprove, Terminating);
   --  Whether the owner has no work with the camera, now or pending

   procedure Wait_Open (Number : out Request_Number);
   --  Until the camera is requested. For the owner only

   procedure Get_Wanted (Number : Request_Number; Wanted : out Boolean)
   with Annotate => (GNATprove, Terminating);
   --  Whether the camera opened for Number is still requested

   procedure Report (Success : Boolean)
   with Annotate => (GNATprove, Terminating);
   --  The outcome of opening it. For the owner only

   procedure Released with Annotate => (GNATprove, Terminating);
   --  The owner has closed the camera

end Vision.Camera_Requests;
