--  SPDX-License-Identifier: GPL-3.0-or-later
--  Images for the vision tests: scenes and plain shapes put into a slot, and
--  files made of them.

with Ada.Numerics.Long_Elementary_Functions;
with Ada.Streams.Stream_IO; use Ada.Streams;

with Libc;
with System;
with Unit_Runs; use Unit_Runs;

package body Pictures is

   Max_Width  : constant := 4_096;
   Max_Height : constant := 2_160;

   type Pixels is array (int range 0 .. Max_Width * Max_Height * 3 - 1)
     of aliased Grey;

   Canvas : Pixels;

   procedure Slot_Load (Slot : int; Bgr : System.Address; Width, Height : int)
   with Import, Convention => C, External_Name => "slot_load";

   procedure Load (Width, Height, Slot : int) is
      --  The canvas into Slot
   begin
      Slot_Load (Slot, Canvas'Address, Width, Height);
   end Load;

   procedure Draw (Scene : Scenes.Description) is
      --  Scene onto the canvas
   begin
      Assert (Scenes.Draw (Scene, Canvas'Address) = 0, "drawn");
   end Draw;

   procedure Show (Scene : Scenes.Description; Slot : int := 0) is
   begin
      Draw (Scene);
      Load (Scene.Width, Scene.Height, Slot);
   end Show;

   procedure Show_Plain (Width, Height : int; Level : Grey; Slot : int := 0) is
   begin
      Canvas (0 .. Width * Height * 3 - 1) := (others => Level);
      Load (Width, Height, Slot);
   end Show_Plain;

   procedure Show_Changed
     (Scene  : Scenes.Description;
      Change : not null access function
        (X, Y : Long_Float; Level : Long_Float) return Long_Float)
   is
      Place : int := 0;
   begin
      Draw (Scene);
      for Row in 0 .. Scene.Height - 1 loop
         for Column in 0 .. Scene.Width - 1 loop
            for K in Place .. Place + 2 loop
               Canvas (K) := Grey
                 (Long_Float'Max
                    (0.0,
                     Long_Float'Min
                       (255.0,
                        Change (Long_Float (Column), Long_Float (Row),
                                Long_Float (Canvas (K))))));
            end loop;
            Place := Place + 3;
         end loop;
      end loop;
      Load (Scene.Width, Scene.Height, 0);
   end Show_Changed;

   procedure Show_Frame
     (Scene         : Scenes.Description;
      Width, Height : double;
      Turn          : double;
      Level         : Grey;
      Border        : double := 0.0;
      Border_Level  : Grey   := 0)
   is
      use Ada.Numerics.Long_Elementary_Functions;
      Cosine : constant Long_Float := Cos (Long_Float (Turn), 360.0);
      Sine   : constant Long_Float := Sin (Long_Float (Turn), 360.0);

      function Is_In (X, Y : Long_Float; Rim : double) return Boolean is
        (abs (X * Cosine + Y * Sine) <= Long_Float (Width / 2.0 + Rim)
         and then abs (Y * Cosine - X * Sine)
           <= Long_Float (Height / 2.0 + Rim));
      --  From the middle of the image

      function Change (X, Y : Long_Float; Here : Long_Float)
        return Long_Float
      is
         U : constant Long_Float := X - Long_Float (Scene.Width) / 2.0;
         V : constant Long_Float := Y - Long_Float (Scene.Height) / 2.0;
      begin
         return (if Is_In (U, V, 0.0) then Long_Float (Level)
                 elsif Is_In (U, V, Border) then Long_Float (Border_Level)
                 else Here);
      end Change;

   begin
      Show_Changed (Scene, Change'Access);
   end Show_Frame;

   procedure Show_Page (Path : String; Scale : int) is
      Width, Height : int;
   begin
      Assert (Scenes.Page (To_C (Path), Scale, Canvas'Address, Canvas'Length,
                           Width, Height) = 0, "drawn");
      Load (Width, Height, 0);
   end Show_Page;

   procedure Check_Size (Slot, Width, Height : int; What : String) is

      procedure Slot_Size (Slot : int; Width, Height : out int)
      with Import, Convention => C, External_Name => "slot_size";

      W, H : int;
   begin
      Slot_Size (Slot, W, H);
      Assert (W = Width and then H = Height,
              What & ": is" & W'Image & " x" & H'Image);
   end Check_Size;

   function Disturbed
     (Turn, Noise, Blur, Uneven : double := 0.0;
      Arena                     : int    := 1)
      return Scenes.Description
   is
   begin
      return Scene : Scenes.Description := Scenes.Default do
         Scene.Turn := Turn;
         Scene.Noise := Noise;
         Scene.Blur := Blur;
         Scene.Uneven := Uneven;
         Scene.Arena := Arena;
      end return;
   end Disturbed;

   function Scene_With
     (Marker, Id    : int;
      X, Y, Heading : double) return Scenes.Description
   is
   begin
      return Scene : Scenes.Description := Scenes.Default do
         Scene.Robots := 1;
         Scene.Robot (0) := (Marker, Id, X, Y, Heading);
      end return;
   end Scene_With;

   function Temporary (Name : String) return String is
      Number : constant String := Libc.Getpid'Image;
   begin
      return "/tmp/destijl_vision_" & Number (2 .. Number'Last) & "_" & Name;
   end Temporary;

   function Photograph
     (Scene : Scenes.Description; Quality : int := 90) return Octets
   is
      Jpeg   : Octets (1 .. 1_000_000);
      Length : constant int :=
        Scenes.Jpeg (Scene, Quality, Jpeg'Address, Jpeg'Length);
   begin
      Assert (Length > 0, "the scene can be encoded");
      return Jpeg (1 .. Natural (Length));
   end Photograph;

   procedure Save (Scene : Scenes.Description; Path : String) is
      File : Stream_IO.File_Type;
   begin
      Stream_IO.Create (File, Name => Path);
      Octets'Write (Stream_IO.Stream (File), Photograph (Scene));
      Stream_IO.Close (File);
   end Save;

   function Contents (Path : String) return String is
      File : Stream_IO.File_Type;
      Text : String (1 .. Natural (Ada.Directories.Size (Path)));
   begin
      Stream_IO.Open (File, Stream_IO.In_File, Path);
      String'Read (Stream_IO.Stream (File), Text);
      Stream_IO.Close (File);
      return Text;
   end Contents;

   procedure Save_Text (Text : String; Path : String) is
      File : Stream_IO.File_Type;
   begin
      Stream_IO.Create (File, Name => Path);
      String'Write (Stream_IO.Stream (File), Text);
      Stream_IO.Close (File);
   end Save_Text;

   procedure Save_Plain (Width, Height : Positive; Path : String) is
   begin
      Save_Text ("P6" & Width'Image & Height'Image & " 255 "
                 & String'(1 .. Width * Height * 3 => Character'Val (120)),
                 Path);
   end Save_Plain;

   procedure Save_Video
     (Scene : Scenes.Description; Frames, Fps : int; Path : String) is
   begin
      Assert (Scenes.Video (Scene, Frames, Fps, To_C (Path)) = 0,
              "the video can be written");
   end Save_Video;

end Pictures;
