--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the images that a monitor receives show.

package Images is

   type Facts is record
      Width, Height : Natural := 0;
      Coloured      : Natural := 0;
      --  Pixels with a clear colour: only what the supervisor draws has one
   end record;

   function Seen (Text : String) return Facts;
   --  Of the base64 text of a JPEG; raises Failed where it is none

   Drawn : constant := 200;
   --  As many coloured pixels has an image with the arena or the robot
   --  drawn, at least: far fewer than any outline

   procedure Find_Marker
     (Text : String; Found : out Boolean; X, Y : out Float);
   --  The centre of the robot's ArUco marker, pixels

   function Is_File (Text : String; Path : String) return Boolean;
   --  Text is the base64 text of the very bytes of a file

   procedure Write_Empty (Path : String);
   --  A file with an image that shows neither arena nor robot

   procedure Write_Yuyv (Image, Path : String);
   --  A file with what the file Image shows, as a camera delivers it that has
   --  YUYV and no colour

end Images;
