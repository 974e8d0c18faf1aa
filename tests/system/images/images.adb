--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the images that a monitor receives show.

with Interfaces.C; use Interfaces.C;

with Expectations; use Expectations;

package body Images is

   function Image_Facts
     (Text   : char_array;
      Length : int;
      Width, Height, Coloured : out int) return int
   with Import, Convention => C, External_Name => "image_facts";

   function Image_Marker
     (Text : char_array; Length : int; X, Y : out double) return int
   with Import, Convention => C, External_Name => "image_marker";

   function Image_Is_File
     (Text : char_array; Length : int; Path : char_array) return int
   with Import, Convention => C, External_Name => "image_is_file";

   function Image_Write_Empty (Path : char_array) return int
   with Import, Convention => C, External_Name => "image_write_empty";

   function Image_Write_Yuyv (Image, Path : char_array) return int
   with Import, Convention => C, External_Name => "image_write_yuyv";

   function Seen (Text : String) return Facts is
      Width, Height, Coloured : int;
   begin
      Check
        (Image_Facts
           (To_C (Text), int (Text'Length), Width, Height, Coloured) = 0,
         "not an image");
      return (Natural (Width), Natural (Height), Natural (Coloured));
   end Seen;

   procedure Find_Marker
     (Text : String; Found : out Boolean; X, Y : out Float)
   is
      Px, Py : double := 0.0;
   begin
      Found := Image_Marker (To_C (Text), int (Text'Length), Px, Py) = 0;
      X := Float (Px);
      Y := Float (Py);
   end Find_Marker;

   function Is_File (Text : String; Path : String) return Boolean is
     (Image_Is_File (To_C (Text), int (Text'Length), To_C (Path)) = 0);

   procedure Write_Empty (Path : String) is
   begin
      Check (Image_Write_Empty (To_C (Path)) = 0, "cannot write " & Path);
   end Write_Empty;

   procedure Write_Yuyv (Image, Path : String) is
   begin
      Check (Image_Write_Yuyv (To_C (Image), To_C (Path)) = 0,
             "cannot write " & Path);
   end Write_Yuyv;

end Images;
