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
--
--  Images are drawn only while somebody looks.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Settings;

package Arena_Camera is

   procedure Start (Port : in out Natural; Problem : out Unbounded_String);
   --  Listens on Port, or on a free one if that is 0. What is set before is
   --  as at first. Call once. Problem is the reason of a failure; "" if none.

   procedure Set (Kind : Settings.Camera_Kind; Value : Integer);
   --  Of the images, from the next one on. Above the sizes of such cameras
   --  (1920 x 1440) one is drawn and sent repeatedly.

   type Mode_Kind is
     (On,
      Stall,     --  streams stay open without images
      Garbage,   --  invalid or damaged images are sent
      Off);      --  streams are closed, new ones rejected
   --  The values of Camera_Mode

   procedure Mend;
   --  All of this as at first

   function Viewers return Natural;
   --  Open streams and snapshots

   function Frames return Natural;
   --  Images drawn so far

end Arena_Camera;
