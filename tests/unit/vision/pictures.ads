--  SPDX-License-Identifier: GPL-3.0-or-later
--  Images for the vision tests: scenes and plain shapes put into a slot, and
--  files made of them.

with Ada.Directories;
with Interfaces.C; use Interfaces.C;
with Scenes;

package Pictures is

   subtype Grey is unsigned_char;

   procedure Show (Scene : Scenes.Description; Slot : int := 0);
   --  Draws Scene into Slot

   procedure Show_Plain (Width, Height : int; Level : Grey; Slot : int := 0);
   --  One grey level all over

   procedure Show_Changed
     (Scene  : Scenes.Description;
      Change : not null access function
        (X, Y : Long_Float; Level : Long_Float) return Long_Float);
   --  Scene with each grey level as Change makes it of that at (X, Y); into
   --  slot 0

   procedure Show_Frame
     (Scene         : Scenes.Description;
      Width, Height : double;
      Turn          : double;
      Level         : Grey;
      Border        : double := 0.0;
      Border_Level  : Grey   := 0);
   --  Scene with a sheet of one grey level in its middle, Width x Height
   --  pixels, turned by Turn degrees, in a border that is Border pixels wide;
   --  into slot 0

   procedure Show_Page (Path : String; Scale : int);
   --  The rectangles of an SVG page in mm, Scale pixels each, into slot 0

   procedure Check_Size (Slot, Width, Height : int; What : String);
   --  Of the image in Slot, which must hold one

   function Disturbed
     (Turn, Noise, Blur, Uneven : double := 0.0;
      Arena                     : int    := 1)
      return Scenes.Description;
   --  The default, so

   function Scene_With
     (Marker, Id    : int;
      X, Y, Heading : double) return Scenes.Description;
   --  The plain scene with one robot

   function Temporary (Name : String) return String;
   --  A path for a file of this run

   type Octets is array (Positive range <>) of aliased Grey;

   function Photograph
     (Scene : Scenes.Description; Quality : int := 90) return Octets;
   --  A JPEG, as a camera delivers it

   procedure Save (Scene : Scenes.Description; Path : String);
   --  That in a file

   procedure Save_Plain (Width, Height : Positive; Path : String);
   --  One grey level, as PPM

   function Contents (Path : String) return String;

   procedure Save_Text (Text : String; Path : String);

   procedure Save_Video
     (Scene : Scenes.Description; Frames, Fps : int; Path : String);

   procedure Remove (Path : String) renames Ada.Directories.Delete_File;

end Pictures;
