--  SPDX-License-Identifier: GPL-3.0-or-later

with Interfaces.C;    use Interfaces.C;
with Vision.C_Shapes; use Vision.C_Shapes;
with Vision.Library.Calls;

package body Vision.Library with
  SPARK_Mode,
  Refined_State => (Camera => Calls.Source,
                    Frames => Calls.Slots,
                    Memory => Calls.Notes)
is

   type Status_Set is array (Status) of Boolean;

   Opening : constant Status_Set :=
     (Done | No_Camera | Bad_Argument | Failed => True, others => False);

   Grabbing : constant Status_Set :=
     (Done | No_Camera | No_Image | Failed => True, others => False);

   Search : constant Status_Set :=
     (Done | Not_Found | Bad_Argument | Failed => True, others => False);

   Drawing : constant Status_Set :=
     (Done | Bad_Argument | Failed => True, others => False);

   Encoding : constant Status_Set :=
     (Done | Too_Small | Bad_Argument | Failed => True, others => False);

   function To_Status (Code : int; Possible : Status_Set) return Status is
     (if Code in 0 .. Status'Pos (Status'Last)
        and then Possible (Status'Val (Code))
      then Status'Val (Code) else Failed);
   --  The literals of Status are in the order of vision_status

   procedure Copy
     (From : Calls.C_Text; Text : out Reason_Text; Last : out Natural)
   with Post => Last <= Text'Last
   is
      --  Up to the first nul
   begin
      Text := (others => ' ');
      Last := 0;
      for K in Text'Range loop
         exit when From (size_t (K)) = nul;
         Text (K) := To_Ada (From (size_t (K)));
         Last := K;
         pragma Loop_Invariant (Last = K);
      end loop;
   end Copy;

   procedure Open
     (Source        : String;
      Width, Height : Side;
      Fps           : Positive;
      Result        : out Status)
   is
      Name : Calls.C_Name := (others => nul);
      Code : int;
   begin
      for K in 1 .. Source'Length loop
         Name (size_t (K - 1)) := To_C (Source (Source'First + (K - 1)));
         pragma Loop_Invariant (Name (Name'Last) = nul);
      end loop;
      Calls.Open (Name, int (Width), int (Height), int (Fps), Code);
      Result := To_Status (Code, Opening);
   end Open;

   procedure Grab (Into : Slot; Result : out Status) is
      Code : int;
   begin
      Calls.Grab (int (Into), Code);
      Result := To_Status (Code, Grabbing);
   end Grab;

   procedure Get_Format (Text : out Reason_Text; Last : out Natural) is
      Format : Calls.C_Text;
   begin
      Calls.Get_Format (Format);
      Copy (Format, Text, Last);
   end Get_Format;

   procedure Close is
   begin
      Calls.Close;
   end Close;

   procedure Find_Arena
     (In_Slot : Slot;
      Arena   : out Arena_Corners;
      Result  : out Status)
   is
      Found  : C_Arena := (others => <>);
      Code   : int;
      Usable : Boolean;
   begin
      Arena := No_Arena;
      Calls.Find_Arena (int (In_Slot), Found, Code);
      Result := To_Status (Code, Search);
      if Result = Done then
         Take_Arena (Found, Arena, Usable);
         if not Usable then
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
      Code  : int;
   begin
      for K in 1 .. Number loop
         Near (K) := To_C (Areas (K));
      end loop;
      Calls.Find_Robots
        (int (In_Slot), Options.Marker_Kind'Pos (Marker),
         To_C (Arena), Use_Arena, Near, int (Number), Found, Total, Code);
      Robots := (others => <>);
      Count := 0;
      Result := To_Status (Code, Search);
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
     (In_Slot : Slot;
      Arena   : Arena_Corners;
      Result  : out Status)
   is
      Code : int;
   begin
      Calls.Draw_Arena (int (In_Slot), To_C (Arena), Code);
      Result := To_Status (Code, Drawing);
   end Draw_Arena;

   procedure Draw_Robot
     (In_Slot : Slot;
      Item    : Robot;
      Result  : out Status)
   is
      Code : int;
   begin
      Calls.Draw_Robot (int (In_Slot), To_C (Item), Code);
      Result := To_Status (Code, Drawing);
   end Draw_Robot;

   procedure Encode
     (From    : Slot;
      Quality : Percentage;
      Buffer  : in out Bytes.Byte_Array;
      Length  : out Natural;
      Result  : out Status)
   is
      Written : int;
      Code    : int;
   begin
      Calls.Encode (int (From), int (Quality), Buffer, Written, Code);
      Length := 0;
      Result := To_Status (Code, Encoding);
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
      Result : out Status)
   is
      Code : int;
   begin
      Calls.Print_Markers (int (First), int (Size), Code);
      Result := To_Status (Code, Drawing);
   end Print_Markers;

   procedure Reason (Text : out Reason_Text; Last : out Natural) is
      Why : Calls.C_Text;
   begin
      Calls.Get_Reason (Why);
      Copy (Why, Text, Last);
   end Reason;

   procedure Library_Version (Text : out Reason_Text; Last : out Natural) is
      Version : Calls.C_Text;
   begin
      Calls.Get_Version (Version);
      Copy (Version, Text, Last);
   end Library_Version;

end Vision.Library;
