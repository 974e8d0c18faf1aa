--  SPDX-License-Identifier: GPL-3.0-or-later
--  The camera and the image processing: the Ada binding of vision_c. It makes
--  no decisions.

with Bytes;
with Options;
with Trace;

package Vision.Library with
  SPARK_Mode,
  Abstract_State =>
    ((Camera with Synchronous, External => (Async_Readers, Async_Writers)),
     (Frames with Synchronous, External => (Async_Readers, Async_Writers)),
     (Memory with Synchronous, External => (Async_Readers, Async_Writers))),
  Initializes    => (Camera, Frames, Memory)
is

   --  Camera is the open source of images. It belongs to one task at a time,
   --  as does each slot of Frames; two tasks may process two slots in
   --  parallel. Memory is what is known of each calling task: the image that
   --  it searched last, and why its last operation failed. Searching and
   --  encoding decode a stored JPEG. Operations on a slot that never held an
   --  image return Bad_Argument. The first operation loads the libraries.
   --  Starts no task, locks nothing, raises no exception. OpenCV was measured
   --  to use up to 52 kB of the calling task's stack.

   type Status is
     (Done,
      Not_Found,     --  no error: no arena, no robot
      No_Camera,     --  the source cannot be opened, or is not open
      No_Image,      --  the source delivered nothing usable
      Too_Small,     --  the buffer cannot hold the result
      Bad_Argument,
      Failed);       --  OpenCV failed internally, out of memory, or the
                     --  camera's JPEG cannot be decoded

   Max_Source : constant := 1_024;
   --  Characters of the name of a source

   subtype Reason_Text is String (1 .. 120);

   procedure Open
     (Source        : String;
      Width, Height : Options.Pixel_Count;
      Fps           : Positive;
      Result        : out Status)
   with
     Global => (In_Out => (Camera, Memory)),
     Pre    => Source'Length <= Max_Source;
   --  What a source can be, and how long this waits for it: vision_open in
   --  vision_c/vision.h. Images are scaled to fit Width x Height

   procedure Grab (Into : Slot; Result : out Status)
   with Global => (In_Out => (Camera, Frames, Memory, Trace.Recorder));
   --  Waits for the next image. The slot is unchanged unless Done. Images of a
   --  live source must be grabbed as fast as they arrive; otherwise they age
   --  in buffers.

   procedure Get_Format (Text : out Reason_Text; Last : out Natural)
   with
     Global => (Input => Camera),
     Post   => Last <= Text'Last;
   --  The mode granted by the source, such as "MJPG 640x480, 30 a second", in
   --  Text (1 .. Last), padded with blanks; empty for a still image

   procedure Close
   with Global => (In_Out => (Camera, Memory));
   --  No effect if nothing is open

   procedure Find_Arena
     (In_Slot : Slot; Arena : out Arena_Corners; Result : out Status)
   with
     Global => (In_Out => (Frames, Memory)),
     Post   => (if Result /= Done then Arena = No_Arena);

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
   with
     Global => (In_Out => (Frames, Memory)),
     Post   => (Result = Done) = (Count > 0);
   --  The robots in the image, lowest identifier first; only inside Arena if
   --  Use_Arena. With a Number, only those in Areas (1 .. Number), and none if
   --  anything else in the image, or Arena, has changed since the calling
   --  task's last search. To be called before drawing, which would hide the
   --  robots.

   procedure Draw_Arena
     (In_Slot : Slot; Arena : Arena_Corners; Result : out Status)
   with Global => (In_Out => (Frames, Memory));

   procedure Draw_Robot
     (In_Slot : Slot; Item : Robot; Result : out Status)
   with Global => (In_Out => (Frames, Memory));

   procedure Encode
     (From    : Slot;
      Quality : Options.Percentage;
      Buffer  : in out Bytes.Byte_Array;
      Length  : out Natural;
      Result  : out Status)
   with
     Global => (In_Out => (Frames, Memory)),
     Post   => Length <= Buffer'Length
       and then (Result = Done) = (Length > 0);
   --  The image as JPEG, in the first Length bytes of Buffer; unless Done the
   --  contents are undefined. It may be the camera's own, whatever Quality

   procedure Print_Markers
     (First  : Options.Marker_Number;
      Size   : Options.Marker_Millimetres;
      Result : out Status)
   with Global => (In_Out => Memory);
   --  A page of markers as SVG on standard output: First and those after it,
   --  as many as fit, each with a black frame of Size

   procedure Reason (Text : out Reason_Text; Last : out Natural)
   with
     Global => (Input => Memory),
     Post   => Last <= Text'Last;
   --  Why the calling task's last operation failed, for the log: Text (1 ..
   --  Last), padded with blanks

end Vision.Library;
