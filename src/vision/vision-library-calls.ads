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

   --  Code is the vision_status, or whatever else was returned

   procedure Open
     (Name : char_array; Width, Height, Fps : int; Code : out int)
   with
     Global => (In_Out => (Source, Notes)),
     Pre    => Name'Length > 0 and then Name (Name'Last) = nul;

   procedure Grab (Into : int; Code : out int)
   with Global => (In_Out => (Source, Slots, Notes));

   procedure Get_Format (Text : out Reason_Text; Last : out Natural)
   with Global => (Input => Source), Post => Last <= Text'Last;

   procedure Close
   with Convention => C, Global => (In_Out => (Source, Notes));
   --  Its status is always that of success

   procedure Find_Arena (In_Slot : int; Arena : in out C_Arena; Code : out int)
   with Global => (In_Out => (Slots, Notes));

   procedure Find_Robots
     (In_Slot, Marker : int;
      Arena           : C_Arena;
      Use_Arena       : Boolean;
      Areas           : C_Areas;
      Number          : int;
      Robots          : in out C_Robots;
      Count, Code     : out int)
   with
     Global => (In_Out => (Slots, Notes)),
     Pre    => Number in 0 .. Areas'Length;
   --  In the areas only, if there are any

   procedure Draw_Arena (In_Slot : int; Arena : C_Arena; Code : out int)
   with Global => (In_Out => (Slots, Notes));

   procedure Draw_Robot (In_Slot : int; Item : C_Robot; Code : out int)
   with Global => (In_Out => (Slots, Notes));

   procedure Encode
     (From, Quality : int;
      Buffer        : in out Bytes.Byte_Array;
      Length        : out int;
      Code          : out int)
   with Global => (In_Out => (Slots, Notes));

   procedure Print_Markers (First, Size : int; Code : out int)
   with Global => (In_Out => Notes);
   --  On standard output

   procedure Get_Reason (Text : out Reason_Text; Last : out Natural)
   with Global => (Input => Notes), Post => Last <= Text'Last;

end Vision.Library.Calls;
