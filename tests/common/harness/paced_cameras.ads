--  SPDX-License-Identifier: GPL-3.0-or-later
--  Cameras of any rate, with jitter, over HTTP on 127.0.0.1: each image of
--  the Motion JPEG says which one it is and when it left.

private with Ada.Finalization;

with Instants; use Instants;

package Paced_Cameras is

   type Camera is tagged limited private;
   --  Stopped when it leaves its scope. For one viewer

   procedure Start
     (Object : in out Camera;
      Image  : String;
      Rate   : Float;
      Jitter : Duration := 0.0);
   --  Image is the path of a JPEG. Each image comes up to Jitter earlier or
   --  later than Rate, in images a second, has it

   function Url (Object : Camera) return String;

   procedure Set_Rate (Object : Camera; Rate : Float);
   --  From the next image on

   procedure Stop (Object : in out Camera);

   type Mark is record
      Number : Natural := 0;
      Time   : Instant := Never;  --  when it left
   end record;

   function Mark_Of (Text : String) return Mark;
   --  Text is the beginning of the base64 text of an image. Raises Failed
   --  where it is none of these cameras

private

   type Parts;
   type Parts_Access is access Parts;

   type Camera is new Ada.Finalization.Limited_Controlled with record
      Inner : Parts_Access;
   end record;

   overriding procedure Finalize (Object : in out Camera) renames Stop;

end Paced_Cameras;
