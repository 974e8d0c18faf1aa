--  SPDX-License-Identifier: GPL-3.0-or-later
--  A camera above the arena, served over HTTP on 127.0.0.1:
--
--  /stream.mjpg    Motion JPEG (multipart/x-mixed-replace), up to 8 viewers;
--                  each gets the newest image when it can take one
--  /snapshot.jpg   one image, the next
--  /pose           the truth now, one line of numbers separated by blanks:
--                  x y heading cx cy dx dy angle frame time
--                  (cm, cm, degrees; pixels; degrees as docs/wire.md has
--                  them; number of the newest image; seconds of
--                  CLOCK_MONOTONIC)
--  /pose/frame     the same as the newest image shows it, with the camera's
--                  delay and the noise of positions; its time is the image's
--
--  Images are drawn only while somebody looks.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

package Arena_Camera is

   subtype Frame_Width is Positive range 1 .. 4_096;
   subtype Frame_Height is Positive range 1 .. 2_304;
   --  Above the sizes of such cameras (1920 x 1440) one image is drawn and
   --  sent repeatedly
   subtype Frame_Rate is Positive range 1 .. 240;
   subtype Noise_Level is Natural range 0 .. 30;
   subtype Delay_Time is Natural range 0 .. 1_000;
   --  Milliseconds
   subtype Displacement is Natural range 0 .. 10;
   --  Pixels, standard deviation
   subtype Marker_Number is Natural range 0 .. 999;
   subtype Opening_Time is Natural range 0 .. 60_000;
   --  Milliseconds

   type Marker_Kind is (Aruco, Triangle);

   type Settings is record
      Width     : Frame_Width   := 640;
      Height    : Frame_Height  := 480;
      Rate      : Frame_Rate    := 25;  --  images a second
      Noise     : Noise_Level   := 3;   --  standard deviation
      Marker    : Marker_Kind   := Aruco;
      Marker_Id : Marker_Number := 1;
      Late      : Delay_Time    := 0;
      --  Images show where the robot was so long ago, or where it was put
      --  down at the start
      Displaced : Displacement  := 0;
      --  Of the robot in each image, in x and in y: any part of a pixel, not
      --  beyond the arena's edge. The n-th image has the same in each run.
      Opening   : Opening_Time  := 0;
      --  Delay of the reply to a request for images
   end record;

   procedure Start
     (Port    : Natural;
      S       : Settings;
      Actual  : out Natural;
      Problem : out Unbounded_String);
   --  Listens on Port, or on a free one (Actual) if Port is 0. Call once.
   --  Problem is the reason of a failure; "" if none.

   type Mode_Kind is
     (On,
      Stalled,   --  streams stay open without images
      Garbage,   --  invalid or damaged images are sent
      Off);      --  streams are closed, new ones rejected

   procedure Set_Mode (Mode : Mode_Kind);

   function Configuration return Settings;
   procedure Configure (S : Settings);
   --  From the next image on

   procedure Mend;
   --  Resets what is set by these

   function Viewers return Natural;
   --  Open streams and snapshots

   function Frames return Natural;
   --  Images drawn so far

end Arena_Camera;
