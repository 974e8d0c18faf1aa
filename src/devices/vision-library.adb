--  SPDX-License-Identifier: GPL-3.0-or-later

with Interfaces.C; use Interfaces.C;
with System;

package body Vision.Library with SPARK_Mode => Off is

   --  The types of vision.h

   type C_Point is record
      X, Y : double;
   end record
   with Convention => C;

   type C_Arena is array (Corner) of C_Point
   with Convention => C;

   type C_Robot is record
      Id        : int;
      Centre    : C_Point;
      Direction : C_Point;
      Angle     : double;
   end record
   with Convention => C;

   type C_Robots is array (Robot_Array'Range) of C_Robot
   with Convention => C;

   type C_Area is record
      Centre : C_Point;
      Reach  : double;
   end record
   with Convention => C;

   type C_Areas is array (Area_Array'Range) of C_Area
   with Convention => C;

   Nowhere : constant C_Point := (0.0, 0.0);

   --  The functions of vision.h

   function C_Open
     (Source : char_array; Width, Height, Fps : int) return int
   with Import, Convention => C, External_Name => "vision_open";

   function C_Grab (Slot : int) return int
   with Import, Convention => C, External_Name => "vision_grab";

   function C_Format return System.Address
   with Import, Convention => C, External_Name => "vision_format";

   function C_Close return int
   with Import, Convention => C, External_Name => "vision_close";

   function C_Find_Arena (Slot : int; Arena : in out C_Arena) return int
   with Import, Convention => C, External_Name => "vision_find_arena";

   function C_Find_Robots
     (Slot, Marker : int;
      Arena        : access constant C_Arena;
      Robots       : in out C_Robots;
      Capacity     : int;
      Count        : out int) return int
   with Import, Convention => C, External_Name => "vision_find_robots";

   function C_Follow_Robots
     (Slot, Marker : int;
      Arena        : access constant C_Arena;
      Areas        : C_Areas;
      Area_Count   : int;
      Robots       : in out C_Robots;
      Capacity     : int;
      Count        : out int) return int
   with Import, Convention => C, External_Name => "vision_follow_robots";

   function C_Draw_Arena (Slot : int; Arena : C_Arena) return int
   with Import, Convention => C, External_Name => "vision_draw_arena";

   function C_Draw_Robot (Slot : int; Item : C_Robot) return int
   with Import, Convention => C, External_Name => "vision_draw_robot";

   function C_Encode
     (Slot, Quality : int;
      Buffer        : System.Address;
      Capacity      : int;
      Length        : out int) return int
   with Import, Convention => C, External_Name => "vision_encode";

   function C_Reason return System.Address
   with Import, Convention => C, External_Name => "vision_reason";

   function C_Library return System.Address
   with Import, Convention => C, External_Name => "vision_library";

   procedure Copy_Text
     (To : in out char_array; From : System.Address; Length : size_t)
   with Import, Convention => C, External_Name => "strncpy";
   --  Of the C library: needs no secondary stack, unlike Interfaces.C.Strings

   --  Conversions. vision.h promises finite numbers within the ranges below.
   --  They are checked nevertheless, since a NaN converts to no integer.

   Pixel_Limit  : constant double := 1.0E7;
   Degree_Limit : constant double := 180.0;
   Micro        : constant double := 1.0E6;

   type Status_Set is array (Status) of Boolean;

   Search : constant Status_Set :=
     (Done | Not_Found | Bad_Argument | Failed => True, others => False);

   Drawing : constant Status_Set :=
     (Done | Bad_Argument | Failed => True, others => False);

   function To_Status (Code : int; Possible : Status_Set) return Status is
     (if Code in 0 .. Status'Pos (Status'Last)
        and then Possible (Status'Val (Code))
      then Status'Val (Code) else Failed);

   function Is_Sound (P : C_Point) return Boolean is
     (P.X'Valid and then P.Y'Valid
      and then abs P.X <= Pixel_Limit and then abs P.Y <= Pixel_Limit);

   function Is_Sound (R : C_Robot) return Boolean is
     (R.Id in int (Identifier'First) .. int (Identifier'Last)
      and then Is_Sound (R.Centre) and then Is_Sound (R.Direction)
      and then R.Angle'Valid and then abs R.Angle <= Degree_Limit);

   function To_Ada (P : C_Point) return Point is
     (X => Micro_Pixels (P.X * Micro), Y => Micro_Pixels (P.Y * Micro));

   function To_C (P : Point) return C_Point is
     (X => double (P.X) / Micro, Y => double (P.Y) / Micro);

   function To_C (A : Arena_Corners) return C_Arena is
     (To_C (A (Top_Left)), To_C (A (Top_Right)),
      To_C (A (Bottom_Right)), To_C (A (Bottom_Left)));

   procedure Copy
     (From : System.Address; Text : out Reason_Text; Last : out Natural);
   --  The C string at From, truncated to the length of Text

   No_Robots : constant C_Robots :=
     (others => (Id        => 0,
                 Centre    => Nowhere,
                 Direction => Nowhere,
                 Angle     => 0.0));

   procedure Take
     (Found  : C_Robots;
      Total  : int;
      Robots : out Robot_Array;
      Count  : out Robot_Count;
      Result : in out Status);
   --  The robots found, if Result is Done

   procedure Take
     (Found  : C_Robots;
      Total  : int;
      Robots : out Robot_Array;
      Count  : out Robot_Count;
      Result : in out Status) is
   begin
      Robots := (others => <>);
      Count := 0;
      if Result = Done and then Total not in 0 .. Found'Length then
         Result := Failed;
      end if;
      if Result = Done then
         for K in 1 .. Natural (Total) loop
            if Is_Sound (Found (K)) then
               Count := Count + 1;
               Robots (Count) :=
                 (Id        => Identifier (Found (K).Id),
                  Centre    => To_Ada (Found (K).Centre),
                  Direction => To_Ada (Found (K).Direction),
                  Angle     => Micro_Degrees (Found (K).Angle * Micro));
            end if;
         end loop;
         if Count = 0 then
            Result := Not_Found;
         end if;
      end if;
   end Take;

   procedure Copy
     (From : System.Address; Text : out Reason_Text; Last : out Natural)
   is
      Local : char_array (1 .. Reason_Text'Length) := (others => nul);
   begin
      Copy_Text (Local, From, Local'Length);
      Text := (others => ' ');
      Last := 0;
      for Next of Local loop
         exit when Next = nul;
         Last := Last + 1;
         Text (Last) := To_Ada (Next);
      end loop;
   end Copy;

   procedure Open
     (Source        : String;
      Width, Height : Side;
      Fps           : Positive;
      Result        : out Status)
   is
      Name  : char_array (0 .. Max_Source) := (others => nul);
      Count : size_t;
   begin
      To_C (Source, Name, Count);
      Result := To_Status
        (C_Open (Name, int (Width), int (Height), int (Fps)),
         (Done | No_Camera | Bad_Argument | Failed => True,
          others => False));
   end Open;

   procedure Grab (Into : Slot; Result : out Status) is
   begin
      Result := To_Status
        (C_Grab (int (Into)),
         (Done | No_Camera | No_Image | Failed => True, others => False));
   end Grab;

   procedure Get_Format (Text : out Reason_Text; Last : out Natural) is
   begin
      Copy (C_Format, Text, Last);
   end Get_Format;

   procedure Close is
      Ignored : int;
      pragma Unreferenced (Ignored);
   begin
      Ignored := C_Close;
   end Close;

   procedure Find_Arena
     (In_Slot : Slot;
      Arena   : out Arena_Corners;
      Result  : out Status)
   is
      Found : C_Arena := (others => Nowhere);
   begin
      Arena := No_Arena;
      Result := To_Status (C_Find_Arena (int (In_Slot), Found), Search);
      if Result = Done then
         if (for all P of Found => Is_Sound (P)) then
            for C in Corner loop
               Arena (C) := To_Ada (Found (C));
            end loop;
         else
            Result := Not_Found;
         end if;
      end if;
   end Find_Arena;

   procedure Find_Robots
     (In_Slot   : Slot;
      Marker    : Options.Marker_Kind;
      Arena     : Arena_Corners;
      Use_Arena : Boolean;
      Robots    : out Robot_Array;
      Count     : out Robot_Count;
      Result    : out Status)
   is
      Limit : aliased constant C_Arena := To_C (Arena);
      Found : C_Robots := No_Robots;
      Total : int;
   begin
      Result := To_Status
        (C_Find_Robots
           (int (In_Slot),
            Options.Marker_Kind'Pos (Marker),
            (if Use_Arena then Limit'Access else null),
            Found, Found'Length, Total), Search);
      Take (Found, Total, Robots, Count, Result);
   end Find_Robots;

   procedure Follow_Robots
     (In_Slot   : Slot;
      Marker    : Options.Marker_Kind;
      Arena     : Arena_Corners;
      Use_Arena : Boolean;
      Areas     : Area_Array;
      Number    : Robot_Count;
      Robots    : out Robot_Array;
      Count     : out Robot_Count;
      Result    : out Status)
   is
      Limit    : aliased constant C_Arena := To_C (Arena);
      Searched : C_Areas;
      Found    : C_Robots := No_Robots;
      Total    : int;
   begin
      for K in Searched'Range loop
         Searched (K) :=
           (To_C (Areas (K).Centre), double (Areas (K).Reach) / Micro);
      end loop;
      Result := To_Status
        (C_Follow_Robots
           (int (In_Slot),
            Options.Marker_Kind'Pos (Marker),
            (if Use_Arena then Limit'Access else null),
            Searched, int (Number), Found, Found'Length, Total), Search);
      Take (Found, Total, Robots, Count, Result);
   end Follow_Robots;

   procedure Draw_Arena
     (In_Slot : Slot;
      Arena   : Arena_Corners;
      Result  : out Status)
   is
   begin
      Result := To_Status
        (C_Draw_Arena (int (In_Slot), To_C (Arena)), Drawing);
   end Draw_Arena;

   procedure Draw_Robot
     (In_Slot : Slot;
      Item    : Robot;
      Result  : out Status)
   is
   begin
      Result := To_Status
        (C_Draw_Robot
           (int (In_Slot),
            (Id        => int (Item.Id),
             Centre    => To_C (Item.Centre),
             Direction => To_C (Item.Direction),
             Angle     => double (Item.Angle) / Micro)), Drawing);
   end Draw_Robot;

   procedure Encode
     (From    : Slot;
      Quality : Percentage;
      Buffer  : in out Bytes.Byte_Array;
      Length  : out Natural;
      Result  : out Status)
   is
      Written : int;
   begin
      Result := To_Status
        (C_Encode (int (From), int (Quality), Buffer'Address,
                   Buffer'Length, Written),
         (Done | Too_Small | Bad_Argument | Failed => True, others => False));
      if Result = Done and then Written not in 1 .. Buffer'Length then
         Result := Failed;
      end if;
      Length := (if Result = Done then Natural (Written) else 0);
   end Encode;

   procedure Reason (Text : out Reason_Text; Last : out Natural) is
   begin
      Copy (C_Reason, Text, Last);
   end Reason;

   procedure Library_Version (Text : out Reason_Text; Last : out Natural) is
   begin
      Copy (C_Library, Text, Last);
   end Library_Version;

end Vision.Library;
