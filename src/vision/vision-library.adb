--  SPDX-License-Identifier: GPL-3.0-or-later

with Interfaces.C;    use Interfaces.C;
with Schedule;
with Vision.C_Shapes; use Vision.C_Shapes;
with Vision.Library.Calls;

package body Vision.Library with
  SPARK_Mode,
  Refined_State => (Camera => Calls.Source,
                    Frames => Calls.Slots,
                    Memory => Calls.Notes)
is

   procedure Open
     (Source        : String;
      Width, Height : Options.Pixel_Count;
      Fps           : Positive;
      Result        : out Status) is
   begin
      Calls.Open (To_C (Source), int (Width), int (Height), int (Fps), Result);
   end Open;

   procedure Grab (Into : Slot; Result : out Status) is
   begin
      Trace.Put (Trace.Wait, Schedule.Th_Camera, Label => Trace.Camera);
      Calls.Grab (int (Into), Result);
      Trace.Put (Trace.Resume, Schedule.Th_Camera);
   end Grab;

   procedure Get_Format (Text : out Reason_Text; Last : out Natural) is
   begin
      Calls.Get_Format (Text, Last);
   end Get_Format;

   procedure Close is
   begin
      Calls.Close;
   end Close;

   procedure Find_Arena
     (In_Slot : Slot; Arena : out Arena_Corners; Result : out Status)
   is
      Found : C_Arena := (others => <>);
   begin
      Arena := No_Arena;
      Calls.Find_Arena (int (In_Slot), Found, Result);
      if Result = Done then
         if Is_Sound (Found) then
            Arena := To_Ada (Found);
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
      Result    : out Status;
      Areas     : Area_Array := (others => <>);
      Number    : Robot_Count := 0)
   is
      Near  : C_Areas := (others => <>);
      Found : C_Robots := (others => <>);
      Total : int;
   begin
      for K in 1 .. Number loop
         Near (K) := To_C (Areas (K));
      end loop;
      Calls.Find_Robots
        (int (In_Slot), Options.Marker_Kind'Pos (Marker),
         To_C (Arena), Use_Arena, Near, int (Number), Found, Total, Result);
      Robots := (others => <>);
      Count := 0;
      if Result = Done then
         if Total in 0 .. int (Robot_Count'Last) then
            Take_Robots (Found, Robot_Count (Total), Robots, Count);
            if Count = 0 then
               Result := Not_Found;
            end if;
         else
            Result := Failed;
         end if;
      end if;
   end Find_Robots;

   procedure Draw_Arena
     (In_Slot : Slot; Arena : Arena_Corners; Result : out Status) is
   begin
      Calls.Draw_Arena (int (In_Slot), To_C (Arena), Result);
   end Draw_Arena;

   procedure Draw_Robot
     (In_Slot : Slot; Item : Robot; Result : out Status) is
   begin
      Calls.Draw_Robot (int (In_Slot), To_C (Item), Result);
   end Draw_Robot;

   procedure Encode
     (From    : Slot;
      Quality : Options.Percentage;
      Buffer  : in out Bytes.Byte_Array;
      Length  : out Natural;
      Result  : out Status)
   is
      Written : int;
   begin
      Calls.Encode (int (From), int (Quality), Buffer, Written, Result);
      Length := 0;
      if Result = Done then
         if Written in 1 .. Buffer'Length then
            Length := Natural (Written);
         else
            Result := Failed;
         end if;
      end if;
   end Encode;

   procedure Print_Markers
     (First  : Options.Marker_Number;
      Size   : Options.Marker_Millimetres;
      Result : out Status) is
   begin
      Calls.Print_Markers (int (First), int (Size), Result);
   end Print_Markers;

   procedure Reason (Text : out Reason_Text; Last : out Natural) is
   begin
      Calls.Get_Reason (Text, Last);
   end Reason;

end Vision.Library;
