--  SPDX-License-Identifier: GPL-3.0-or-later
--  What is asked of the camera's owner: open it, close it. Nobody but
--  th_cameraControl waits for a camera that takes long to open.

with Vision.Camera_Demands;

package Vision.Camera_Requests with SPARK_Mode is

   subtype Request_Number is Vision.Camera_Demands.Request_Number;

   procedure Open (Success : out Boolean);
   --  Asks for the camera and waits for what comes of it. For
   --  th_cameraControl only

   procedure Close with Annotate => (GNATprove, Terminating);
   --  The camera is no longer wanted. Does not wait

   procedure Get_Idle (Idle : out Boolean)
   with Annotate => (GNATprove, Terminating);
   --  Whether the owner has released the camera

   procedure Wait_Open (Number : out Request_Number);
   --  Until the camera is wanted. For the owner only

   procedure Get_Wanted (Number : Request_Number; Wanted : out Boolean)
   with Annotate => (GNATprove, Terminating);
   --  Whether the camera opened for Number is wanted still

   procedure Report (Success : Boolean)
   with Annotate => (GNATprove, Terminating);
   --  What came of opening it. For the owner only

   procedure Released with Annotate => (GNATprove, Terminating);
   --  The owner has closed the camera

end Vision.Camera_Requests;
