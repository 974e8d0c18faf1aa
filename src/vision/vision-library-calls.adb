--  SPDX-License-Identifier: GPL-3.0-or-later

with Interfaces.C.Strings; use Interfaces.C.Strings;
with System;               use System;

package body Vision.Library.Calls with
  SPARK_Mode    => Off,
  Refined_State => (Source => null, Slots => null, Notes => null)
is

   function C_Open (Source : char_array; Width, Height, Fps : int) return int
   with Import, Convention => C, External_Name => "vision_open";

   function C_Grab (Slot : int) return int
   with Import, Convention => C, External_Name => "vision_grab";

   function C_Format return chars_ptr
   with Import, Convention => C, External_Name => "vision_format";

   procedure C_Close
   with Import, Convention => C, External_Name => "vision_close";

   function C_Find_Arena (Slot : int; Arena : in out C_Arena) return int
   with Import, Convention => C, External_Name => "vision_find_arena";

   function C_Find_Robots
     (Slot, Marker : int;
      Arena        : Address;
      Robots       : in out C_Robots;
      Capacity     : int;
      Count        : out int;
      Areas        : Address;
      Area_Count   : int) return int
   with Import, Convention => C, External_Name => "vision_find_robots";

   function C_Draw_Arena (Slot : int; Arena : C_Arena) return int
   with Import, Convention => C, External_Name => "vision_draw_arena";

   function C_Draw_Robot (Slot : int; Item : C_Robot) return int
   with Import, Convention => C, External_Name => "vision_draw_robot";

   function C_Encode
     (Slot, Quality : int;
      Buffer        : Address;
      Capacity      : int;
      Length        : out int) return int
   with Import, Convention => C, External_Name => "vision_encode";

   function C_Print_Markers (Descriptor, First, Size : int) return int
   with Import, Convention => C, External_Name => "vision_print_markers";

   function C_Reason return chars_ptr
   with Import, Convention => C, External_Name => "vision_reason";

   procedure Copy
     (From : chars_ptr; Text : out Reason_Text; Last : out Natural)
   is
      What : constant String := Value (From, Text'Length);
   begin
      Text := (others => ' ');
      Text (1 .. What'Length) := What;
      Last := What'Length;
   end Copy;

   --  A NaN or an infinity converts to no integer, and SPARK knows of none:
   --  out of range instead

   function Numbers (P : C_Point) return C_Point is
     ((if P.X'Valid then P.X else double'Last),
      (if P.Y'Valid then P.Y else double'Last));

   function Numbers (R : C_Robot) return C_Robot is
     (R.Id, Numbers (R.Centre), Numbers (R.Direction),
      (if R.Angle'Valid then R.Angle else double'Last));

   procedure Open
     (Name : char_array; Width, Height, Fps : int; Result : out Status) is
   begin
      Result := To_Status (C_Open (Name, Width, Height, Fps));
   end Open;

   procedure Grab (Into : int; Result : out Status) is
   begin
      Result := To_Status (C_Grab (Into));
   end Grab;

   procedure Get_Format (Text : out Reason_Text; Last : out Natural) is
   begin
      Copy (C_Format, Text, Last);
   end Get_Format;

   procedure Close renames C_Close;

   procedure Find_Arena
     (In_Slot : int; Arena : in out C_Arena; Result : out Status) is
   begin
      Result := To_Status (C_Find_Arena (In_Slot, Arena));
      for P of Arena loop
         P := Numbers (P);
      end loop;
   end Find_Arena;

   procedure Find_Robots
     (In_Slot, Marker : int;
      Arena           : C_Arena;
      Use_Arena       : Boolean;
      Areas           : C_Areas;
      Number          : int;
      Robots          : in out C_Robots;
      Count           : out int;
      Result          : out Status)
   is
      Inside : constant Address :=
        (if Use_Arena then Arena'Address else Null_Address);
      Near   : constant Address :=
        (if Number > 0 then Areas'Address else Null_Address);
   begin
      Result := To_Status
        (C_Find_Robots (In_Slot, Marker, Inside, Robots, Robots'Length, Count,
                        Near, Number));
      for R of Robots loop
         R := Numbers (R);
      end loop;
   end Find_Robots;

   procedure Draw_Arena
     (In_Slot : int; Arena : C_Arena; Result : out Status) is
   begin
      Result := To_Status (C_Draw_Arena (In_Slot, Arena));
   end Draw_Arena;

   procedure Draw_Robot
     (In_Slot : int; Item : C_Robot; Result : out Status) is
   begin
      Result := To_Status (C_Draw_Robot (In_Slot, Item));
   end Draw_Robot;

   procedure Encode
     (From, Quality : int;
      Buffer        : in out Bytes.Byte_Array;
      Length        : out int;
      Result        : out Status) is
   begin
      Result := To_Status
        (C_Encode (From, Quality, Buffer'Address, Buffer'Length, Length));
   end Encode;

   procedure Print_Markers (First, Size : int; Result : out Status) is
   begin
      Result := To_Status (C_Print_Markers (1, First, Size));
   end Print_Markers;

   procedure Get_Reason (Text : out Reason_Text; Last : out Natural) is
   begin
      Copy (C_Reason, Text, Last);
   end Get_Reason;

end Vision.Library.Calls;
