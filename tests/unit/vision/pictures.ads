--  SPDX-License-Identifier: GPL-3.0-or-later
--  Images for the vision tests: scenes and plain shapes put into a slot, and
--  files made of them.

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
      Border        : double;
      Border_Level  : Grey);
   --  Scene with a sheet of one grey level in its middle, Width x Height
   --  pixels, turned by Turn degrees, in a border that is Border pixels wide;
   --  into slot 0

   procedure Show_Sheet
     (Scene         : Scenes.Description;
      Width, Height : double;
      Turn          : double;
      Level         : Grey);
   --  The same sheet without a border

   procedure Show_Page (Text : String; Scale : Positive);
   --  The rectangles of an SVG page in mm, Scale pixels each, into slot 0.
   --  They are subpaths "Mx yhWvHh-Wz", and an attribute fill is before them

   procedure Show_Aslant (Scene : Scenes.Description; G, H : Long_Float);
   --  What Scene shows at (X, Y), seen at (X, Y) / (1 + G X + H Y), both from
   --  the middle of the image; into slot 0

   procedure Check_Size (Slot, Width, Height : int; What : String);
   --  Of the image in Slot, which must hold one

   function Disturbed
     (Turn, Noise, Blur, Uneven : double := 0.0) return Scenes.Description;
   --  The default, so

   function Scene_With
     (Marker, Id    : int;
      X, Y, Heading : double) return Scenes.Description;
   --  The plain scene with one robot

   function Temporary (Name : String) return String;
   --  A path for a file of this run

   procedure Save (Scene : Scenes.Description; Path : String);
   --  As JPEG

   procedure Save_Plain (Width, Height : Positive; Path : String);
   --  One grey level, as PPM

   function Contents (Path : String) return String;

   procedure Save_Text (Text : String; Path : String);

   procedure Save_Video
     (Scene : Scenes.Description; Frames, Fps : int; Path : String);

   procedure Remove (Path : String);

end Pictures;
