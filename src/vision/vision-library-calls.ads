--  SPDX-License-Identifier: GPL-3.0-or-later
--  The functions of vision_c/vision.h, one call each. A result that is not a
--  number arrives as one that is out of range.

with Bytes;
with Interfaces.C;    use Interfaces.C;
with Vision.C_Shapes; use Vision.C_Shapes;

private package Vision.Library.Calls with
  SPARK_Mode,
  Abstract_State =>
    ((Source with Synchronous, External => (Async_Readers, Async_Writers),
        Part_Of => Vision.Library.Camera),
     (Slots with Synchronous, External => (Async_Readers, Async_Writers),
        Part_Of => Vision.Library.Frames),
     (Notes with Synchronous, External => (Async_Readers, Async_Writers),
        Part_Of => Vision.Library.Memory)),
  Initializes => (Source, Slots, Notes)
is

   function To_Status (Code : int) return Status is
     (if Code in 0 .. Status'Pos (Status'Last) then Status'Val (Code)
      else Failed);
   --  The literals of Status are in the order of vision_status

   procedure Open
     (Name : char_array; Width, Height, Fps : int; Result : out Status)
   with
     Global => (In_Out => (Source, Notes)),
     Pre    => Name'Length > 0 and then Name (Name'Last) = nul;

   procedure Grab (Into : int; Result : out Status)
   with Global => (In_Out => (Source, Slots, Notes));

   procedure Get_Format (Text : out Reason_Text; Last : out Natural)
   with Global => (Input => Source), Post => Last <= Text'Last;

   procedure Close
   with Convention => C, Global => (In_Out => (Source, Notes));
   --  Its status is always that of success

   procedure Find_Arena
     (In_Slot : int; Arena : in out C_Arena; Result : out Status)
   with Global => (In_Out => (Slots, Notes));

   procedure Find_Robots
     (In_Slot, Marker : int;
      Arena           : C_Arena;
      Use_Arena       : Boolean;
      Areas           : C_Areas;
      Number          : int;
      Robots          : in out C_Robots;
      Count           : out int;
      Result          : out Status)
   with
     Global => (In_Out => (Slots, Notes)),
     Pre    => Number in 0 .. Areas'Length;
   --  In the areas only, if there are any

   procedure Draw_Arena
     (In_Slot : int; Arena : C_Arena; Result : out Status)
   with Global => (In_Out => (Slots, Notes));

   procedure Draw_Robot
     (In_Slot : int; Item : C_Robot; Result : out Status)
   with Global => (In_Out => (Slots, Notes));

   procedure Encode
     (From, Quality : int;
      Buffer        : in out Bytes.Byte_Array;
      Length        : out int;
      Result        : out Status)
   with Global => (In_Out => (Slots, Notes));

   procedure Print_Markers (First, Size : int; Result : out Status)
   with Global => (In_Out => Notes);
   --  On standard output

   procedure Get_Reason (Text : out Reason_Text; Last : out Natural)
   with Global => (Input => Notes), Post => Last <= Text'Last;

end Vision.Library.Calls;
