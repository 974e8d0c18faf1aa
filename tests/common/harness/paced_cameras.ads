--  SPDX-License-Identifier: GPL-3.0-or-later
--  Cameras of any rate, with jitter, over HTTP on 127.0.0.1: each image of the
--  Motion JPEG contains its number and the time of its sending.

private with Ada.Finalization;

with Instants; use Instants;

package Paced_Cameras is

   type Camera is tagged limited private;
   --  Stopped at the end of its scope. For one viewer

   procedure Start
     (Object : in out Camera;
      Image  : String;
      Rate   : Float;
      Jitter : Duration := 0.0);
   --  Image is the path of a JPEG. Each image is sent up to Jitter earlier or
   --  later than at Rate, in images per second

   function Url (Object : Camera) return String;

   procedure Set_Rate (Object : Camera; Rate : Float);
   --  From the next image on

   procedure Stop (Object : in out Camera);

   type Mark is record
      Number : Natural := 0;
      Time   : Instant := Never;  --  when it was sent
   end record;

   function Mark_Of (Text : String) return Mark;
   --  Text is the beginning of the base64 text of an image. Raises Failed if
   --  it is not from such a camera

private

   type Parts;
   type Parts_Access is access Parts;

   type Camera is new Ada.Finalization.Limited_Controlled with record
      Inner : Parts_Access;
   end record;

   overriding procedure Finalize (Object : in out Camera) renames Stop;

end Paced_Cameras;
