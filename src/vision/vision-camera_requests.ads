--  SPDX-License-Identifier: GPL-3.0-or-later
--  Requests to the camera's owner: open, close. Only th_cameraControl waits
--  for a camera that is slow to open, which may then no longer be needed.

with Schedule;

package Vision.Camera_Requests with SPARK_Mode is

   type Request_Number is mod 2 ** 32;

   protected Requests with Priority => Schedule.Camera_Ceiling is

      procedure Open;
      --  The camera is requested. Earlier requests are withdrawn

      procedure Close;
      --  The camera is no longer requested. Does not wait

      procedure Get_Idle (Value : out Boolean);
      --  Whether the owner has no work with the camera, now or pending

      procedure Take (Number : out Request_Number; Found : out Boolean);
      --  A new request, even if it has been withdrawn: th_cameraControl waits
      --  for its outcome

      procedure Get_Wanted (Number : Request_Number; Value : out Boolean);
      --  Whether the camera opened for Number is still requested

      procedure Report (Success : Boolean);
      procedure Collect (Success : out Boolean);
      --  The outcome of opening it, from its owner to th_cameraControl

      procedure Released;
      --  The owner has closed the camera

   private
      Current : Request_Number := 0;
      Wanted  : Boolean := False;
      Pending : Boolean := False;
      --  requested, not yet accepted
      Held    : Boolean := False;
      --  the owner has accepted, and not closed the camera since
      Opened  : Boolean := False;
   end Requests;

   procedure Open (Success : out Boolean);
   --  Requests the camera and waits for the outcome. For th_cameraControl only

   procedure Wait_Open (Number : out Request_Number);
   --  Until the camera is requested. For the owner only

   procedure Report (Success : Boolean)
   with Annotate => (GNATprove, Terminating);
   --  The outcome of opening it. For the owner only

   procedure Begin_Images with Annotate => (GNATprove, Terminating);
   --  The camera is open, for the session that has asked for it

   procedure Wait_Images;
   --  For Begin_Images. For th_captureImg only

end Vision.Camera_Requests;
