--  SPDX-License-Identifier: GPL-3.0-or-later
--  The camera's own JPEG: passed on as it is, or decoded, or refused.

with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Interfaces.C;      use Interfaces.C;
with System;

with Pictures; use Pictures;
with Scenes;
with Vision_C; use Vision_C;
with Unit_Runs; use Unit_Runs;

procedure Vision_Jpeg_Tests is

   subtype Octet is unsigned_char;

   Buffer : Octets (1 .. 1_000_000);
   --  What the monitor would be sent

   Room : Robot_Array (0 .. 7);

   function Slot_Load_Jpeg
     (Slot          : int;
      Jpeg          : System.Address;
      Length        : int;
      Width, Height : int) return Status
   with Import, Convention => C, External_Name => "slot_load_jpeg";

   function Load (Jpeg : Octets; Width, Height : int) return Status is
     (Slot_Load_Jpeg (0, Jpeg'Address, Jpeg'Length, Width, Height));
   --  Into slot 0

   procedure Load (Jpeg : Octets) is
      --  For images of its own size, 640 x 480, with success
   begin
      Assert (Load (Jpeg, 640, 480) = Ok, "loaded");
   end Load;

   function Sent (Quality : int := 80; Capacity : int := Buffer'Length)
     return Octets
   is
      --  Of slot 0
      Length : aliased int;
   begin
      Assert (Encode (0, Quality, Buffer'Address, Capacity, Length'Access)
              = Ok, "encoded");
      return Buffer (1 .. Natural (Length));
   end Sent;

   procedure Check_Passed (Jpeg, Shown : Octets; What : String) is
      --  Jpeg is loaded, and Shown is what is sent
   begin
      Load (Jpeg);
      Assert (Sent = Shown, What);
   end Check_Passed;

   procedure Check_Anew (Jpeg, Made : Octets; What : String) is
      --  Made is another image than Jpeg, whole and one that can be decoded
   begin
      Assert (Made /= Jpeg, What & ": encoded anew");
      Check_Passed (Made, Made, What & ": and well");
   end Check_Anew;

   procedure Refuse (Jpeg : Octets; What : String) is
   begin
      Assert (Load (Jpeg, 640, 480) = No_Image, What);
   end Refuse;

   function Position (Jpeg : Octets; Marker : Octet) return Positive is
      --  Of the first segment of the head that is so marked; an image of ours
      --  has one
   begin
      for K in Jpeg'First .. Jpeg'Last - 1 loop
         if Jpeg (K) = 16#FF# and then Jpeg (K + 1) = Marker then
            return K;
         end if;
      end loop;
      Assert (False, "no such segment");
      return 1;
   end Position;

   --  Markers of a JPEG (T.81, table B.1)

   Frame  : constant := 16#C0#;
   Codes  : constant := 16#C4#;
   Scan   : constant := 16#DA#;
   Restart : constant := 16#D0#;
   Quanta : constant := 16#DB#;

   procedure Test_Passed is
      Scene : constant Scenes.Description :=
        Scene_With (0, 5, 40.0, 30.0, 10.0);
      Field : aliased Arena;
      Count : aliased int;
   begin
      for Quality in int range 1 .. 10 loop
         declare
            Jpeg : constant Octets := Photograph (Scene, 10 * Quality);
         begin
            Load (Jpeg);
            Assert (Sent (Quality => 1) = Jpeg, "its own bytes");
            Check_Size (0, 640, 480, "size");
            if Quality > 3 then
               Assert (Find_Arena (0, Field'Access) = Ok, "arena");
               Assert (Find_Robots (0, Aruco, Field'Access, Room'Address, 8,
                                    Count'Access) = Ok
                       and then Count = 1 and then Room (0).Id = 5, "robot");
               Assert (Sent = Jpeg, "still, after searches");
            end if;
         end;
      end loop;
   end Test_Passed;

   procedure Test_Drawn is
      Jpeg  : constant Octets := Photograph (Scenes.Default);
      Field : aliased constant Arena :=
        (Corner => ((20.0, 20.0), (300.5, 20.0), (300.0, 200.0),
                    (20.0, 200.0)));
      Robot : aliased constant Vision_C.Robot :=
        (999, (150.0, 100.0), (170.0, 110.0), 0.0);
   begin
      Load (Jpeg);
      Assert (Draw_Arena (0, Field'Access) = Ok, "draw the arena");
      Check_Anew (Jpeg, Sent, "arena");
      Load (Jpeg);
      Assert (Draw_Robot (0, Robot'Access) = Ok, "draw a robot");
      Check_Anew (Jpeg, Sent, "robot");
      Check_Passed (Jpeg, Jpeg, "a drawing does not stay");
   end Test_Drawn;

   procedure Test_Other_Size is

      procedure Check (From_W, From_H, To_W, To_H : int) is
         --  Fitted into 640 x 480
         Scene : Scenes.Description := Scenes.Default;
         What  : constant String := From_W'Image & " x" & From_H'Image;
      begin
         Scene.Width := From_W;
         Scene.Height := From_H;
         declare
            Jpeg : constant Octets := Photograph (Scene);
         begin
            Load (Jpeg);
            Check_Size (0, To_W, To_H, What & ": size");
            declare
               Made : constant Octets := Sent;
            begin
               Assert ((Made = Jpeg) = (From_W = To_W and then From_H = To_H),
                       What & ": as it is, or scaled");
               Load (Made);
               Check_Size (0, To_W, To_H, What & ": sent");
            end;
         end;
      end Check;
   begin
      Check (640, 480, 640, 480);
      Check (640, 360, 640, 360);
      Check (320, 240, 640, 480);
      Check (1_280, 960, 640, 480);
      Check (3_840, 2_160, 640, 360);
      Check (700, 500, 640, 457);
      Check (1, 1, 480, 480);
      Check (3_000, 2, 640, 1);
      Check (2, 3_000, 1, 480);
   end Test_Other_Size;

   procedure Test_Behind_The_End is
      Jpeg : constant Octets := Photograph (Scenes.Default);
   begin
      --  A driver's buffer is not always cut
      Check_Passed (Jpeg & Octets'(1 .. 5_000 => 0), Jpeg, "zeros");
      Check_Passed (Jpeg & Jpeg, Jpeg, "another image");
      Check_Passed (Jpeg & Octets'(16#0D#, 16#0A#), Jpeg, "end of a line");
   end Test_Behind_The_End;

   procedure Test_Cut is
      Jpeg  : constant Octets := Photograph (Scenes.Default);
      Begun : constant Positive := Position (Jpeg, Scan) + 14;
      --  where the code begins
   begin
      for Last in 1 .. Begun - 1 loop
         Refuse (Jpeg (1 .. Last), "a head of" & Last'Image);
      end loop;
      for Part in 1 .. 20 loop
         declare
            Last : constant Positive :=
              Begun + (Jpeg'Last - 1 - Begun) * Part / 20;
         begin
            --  What there is of it is shown
            Load (Jpeg (1 .. Last));
            Check_Anew (Jpeg (1 .. Last), Sent, "cut at" & Last'Image);
         end;
      end loop;
   end Test_Cut;

   procedure Test_No_Image is
      Noise : Octets (1 .. 20_000);
      State : unsigned := 1;
      Jpeg  : constant Octets := Photograph (Scenes.Default);
   begin
      Load (Jpeg);
      for Round in 1 .. 50 loop
         for B of Noise loop
            State := State * 1_664_525 + 1_013_904_223;
            B := Octet (State / 2 ** 16 mod 2 ** 8);
         end loop;
         Refuse (Noise, "noise");
         Refuse (Jpeg (1 .. 2) & Noise, "noise with a beginning");
      end loop;
      Refuse ((1 .. 1 => 16#FF#), "one byte");
      Refuse ((1 .. 9_999 => 0), "zeros");
      Assert (Sent = Jpeg, "the slot keeps what it had");
   end Test_No_Image;

   procedure Test_Impossible is
      type Lengths is array (Positive range <>) of Natural;
      Whole : constant Octets := Photograph (Scenes.Default);
      Place : constant Positive := Position (Whole, Frame) + 5;

      function Sized (Height, Width : Natural) return Octets is
        (Whole (1 .. Place - 1)
         & (Octet (Height / 256), Octet (Height mod 256),
            Octet (Width / 256), Octet (Width mod 256))
         & Whole (Place + 4 .. Whole'Last));

      Jpeg : Octets := Whole;
   begin
      for Long of Lengths'(0, 8_193, 40_000, 65_535) loop
         Refuse (Sized (Long, 640), "height" & Long'Image);
         Refuse (Sized (480, Long), "width" & Long'Image);
      end loop;
      Load (Sized (480, 640));

      --  More codes of one bit than there can be
      Jpeg (Position (Jpeg, Codes) + 5) := 200;
      Refuse (Jpeg, "codes");
      Jpeg := Whole;
      for Table in 1 .. 2 loop
         Jpeg (Position (Jpeg, Quanta) + 1) := 16#EF#;
      end loop;
      Refuse (Jpeg, "no quantization");
   end Test_Impossible;

   procedure Test_No_Tables is
      Whole : constant Octets := Photograph (Scenes.Default);
      First : constant Positive := Position (Whole, Codes);
      Last  : constant Positive := Position (Whole, Scan);
      Jpeg  : constant Octets :=
        Whole (1 .. First - 1) & Whole (Last .. Whole'Last);
      --  As many USB cameras have it: the usual tables are left out
      Count : aliased int;
   begin
      Check_Passed (Whole, Whole, "with its tables");
      Load (Jpeg);
      declare
         Made : constant Octets := Sent (Quality => 90);
      begin
         Check_Anew (Jpeg, Made, "without tables");
         Assert (Position (Made, Codes) > 1, "now with tables");
      end;
      Load (Jpeg);
      Assert (Find_Robots (0, Aruco, null, Room'Address, 8, Count'Access)
              = Not_Found, "can be searched");
   end Test_No_Tables;

   procedure Test_Damaged_Inside is
      Jpeg   : Octets := Photograph (Scenes.Default);
      Middle : constant Positive := Jpeg'Last / 2;
      First  : constant Positive := Position (Jpeg, Scan) + 100;
      State  : unsigned := 7;
      Place  : Positive;
      Field  : aliased Arena;
   begin
      --  What only decoding would show is passed on, and can be decoded
      for Number in 1 .. 100 loop
         State := State * 1_664_525 + 1_013_904_223;
         Place := First + Natural (State / 2 ** 8) mod (Jpeg'Last - 3 - First);
         if Jpeg (Place) /= 16#FF# and then Jpeg (Place - 1) /= 16#FF# then
            Jpeg (Place) := Octet (State / 2 ** 16 mod 2 ** 7);
         end if;
      end loop;
      Check_Passed (Jpeg, Jpeg, "passed on");
      Assert (Find_Arena (0, Field'Access) in Ok | Not_Found, "decoded");
      Jpeg (Middle .. Middle + 1) := (16#FF#, Restart);
      Check_Passed (Jpeg, Jpeg, "a restart may stand there");
      Jpeg (Middle + 1) := Quanta;
      Load (Jpeg);
      Check_Anew (Jpeg, Sent, "a table in the code");
   end Test_Damaged_Inside;

   procedure Test_Too_Large is
      Scene : Scenes.Description := Scenes.Default;
   begin
      Scene.Noise := 20.0;
      declare
         Jpeg : constant Octets := Photograph (Scene, 100);
      begin
         Load (Jpeg);
         Assert (Sent (Capacity => Jpeg'Length) = Jpeg, "just fits");
         Check_Anew (Jpeg, Sent (Quality => 50, Capacity => Jpeg'Length - 1),
                     "too large as it is");
      end;
   end Test_Too_Large;

   procedure Test_Video is
      --  Of six images the third and the fourth have no head any more, once
      --  it is damaged
      Path  : constant String := Temporary ("own.avi");
      Scene : Scenes.Description := Scenes.Default;
      Found : Natural := 0;

      function Is_Sent (Whole : String) return Boolean is
         --  What the slot sends is a part of Whole
         Image : constant Octets := Sent;
         Text  : String (Image'Range);
      begin
         for K in Text'Range loop
            Text (K) := Character'Val (Image (K));
         end loop;
         return Index (Whole, Text) > 0;
      end Is_Sent;

      procedure Check_Each (Whole, What : String) is
         --  Whole images of it
      begin
         Save_Text (Whole, Path);
         Assert (Open (To_C (Path), 640, 480, 10) = Ok, "open, " & What);
         for Round in 1 .. 9 loop
            Assert (Grab (0) = Ok, "grab" & Round'Image & What);
            Assert (Is_Sent (Whole), "its own" & Round'Image & What);
         end loop;
      end Check_Each;
   begin
      Scene.Noise := 3.0;
      Save_Video (Scene, 6, 25, Path);
      declare
         Whole : String := Contents (Path);
      begin
         Check_Each (Whole, "as it is");
         Assert (Open (To_C (Path), 320, 480, 10) = Ok, "open for less");
         Assert (Grab (0) = Ok and then not Is_Sent (Whole), "encoded anew");
         for K in Whole'First .. Whole'Last - 2 loop
            if Whole (K .. K + 2) = Character'Val (16#FF#)
              & Character'Val (16#D8#) & Character'Val (16#FF#)
            then
               Found := Found + 1;
               if Found in 3 | 4 then
                  Whole (K + 2 .. K + 300) := (others => ASCII.NUL);
               end if;
            end if;
         end loop;
         Assert (Found = 6, "six images");
         Check_Each (Whole, "damaged");
         Assert (Close = Ok, "close");
      end;
      Remove (Path);
   end Test_Video;

begin
   Run_Test ("passed on as it is", Test_Passed'Access);
   Run_Test ("not when drawn in", Test_Drawn'Access);
   Run_Test ("nor of another size", Test_Other_Size'Access);
   Run_Test ("what stands behind its end", Test_Behind_The_End'Access);
   Run_Test ("cut anywhere", Test_Cut'Access);
   Run_Test ("no image at all", Test_No_Image'Access);
   Run_Test ("absurd sizes, impossible tables", Test_Impossible'Access);
   Run_Test ("the usual tables", Test_No_Tables'Access);
   Run_Test ("damaged inside, markers in the code",
             Test_Damaged_Inside'Access);
   Run_Test ("too large to be sent", Test_Too_Large'Access);
   Run_Test ("the images of a video, whole and damaged", Test_Video'Access);
end Vision_Jpeg_Tests;
