--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the tasks share of the vision: its mode, the newest sighting of the
--  robot, and the requests to the camera's owner. Only th_cameraControl waits
--  for a camera that is slow to open, which may then no longer be needed.

with Ada.Real_Time; use Ada.Real_Time;
with Commands; use Commands;
with Schedule;
with Vision.Following;
with Vision.Mode;

package Vision.State with SPARK_Mode is

   protected Store with Priority => Schedule.Vision_Ceiling is

      --  The mode, as Vision.Mode decides

      procedure Begin_Session (First : Ticket);
      --  Sets the initial state; orders with a lower number are refused

      procedure Get (Now : out Vision.Mode.State);

      procedure Change
        (What   : Vision.Mode.Change;
         Number : Ticket;
         Done   : out Boolean;
         Arena  : Arena_Corners := No_Arena);
      --  By the order Number; not Done if it is not possible now, or if the
      --  order's session has ended. Arena: as After has it

      procedure Give_Up (Was_Open : out Boolean);
      --  The camera has failed

      --  The opening of the camera

      procedure Ask_Open
        (Number : Ticket; Needed : out Boolean; Is_Open : out Boolean);
      --  Needed: the camera is requested now. Is_Open: it is already open.
      --  Neither: it is being opened, or the session has ended

      procedure Take (Number : out Ticket; Found : out Boolean);
      --  A new request, even if it has been withdrawn: th_cameraControl waits
      --  for its outcome

      procedure Get_Wanted (Number : Ticket; Wanted : out Boolean);
      --  Whether the camera that was requested by Number still is

      procedure Report (Success : Boolean);

      procedure Opened (Number : Ticket; Is_Open : out Boolean);
      --  Takes over what has been reported. Not Is_Open also if the session
      --  has ended or the camera has failed meanwhile

      procedure Released;
      --  The owner has closed the camera

      procedure Get_Idle (Idle : out Boolean);
      --  Whether the owner has no work with the camera, now or pending

      --  The robot

      procedure Put
        (Came    : Time;
         Robots  : Robot_Array;
         Count   : Robot_Count;
         Awaited : out Boolean);

      procedure Get_Sighting (Newest : out Vision.Following.Sighting);
      --  Since the camera was opened

      procedure Watch (On : Boolean);
      --  A mission begins or has ended. For th_mission only

   private
      Current : Vision.Mode.State;
      Opener  : Ticket := 0;
      --  the order that has requested the camera last
      Pending : Boolean := False;
      --  requested, not yet accepted
      Held    : Boolean := False;
      --  the owner has accepted, and not closed the camera since
      Outcome : Boolean := False;
      --  of the last opening
      Known   : Vision.Following.Sighting;
      Watched : Boolean := False;
   end Store;

   procedure Open (Number : Ticket; Is_Open : out Boolean);
   --  Opens the camera, unless it is open, and begins the images. For
   --  th_cameraControl only

   procedure Wait_Open (Number : out Ticket);
   --  Until the camera is requested. For the owner only

   procedure Report (Success : Boolean)
   with Annotate => (GNATprove, Terminating);
   --  The outcome of opening it. For the owner only

   procedure Wait_Images;
   --  Until the camera has been opened. For th_captureImg only

   procedure Put (Came : Time; Robots : Robot_Array; Count : Robot_Count)
   with Annotate => (GNATprove, Terminating);
   --  The image that came at Came has been searched, and has Robots (1 ..
   --  Count). Wakes th_mission while that watches

   procedure Wait_Sighting (Limit : Time);
   --  Until an image has been searched, or Limit. For th_mission only

end Vision.State;
