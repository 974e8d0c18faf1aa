--  SPDX-License-Identifier: GPL-3.0-or-later
--  The camera, and what is seen in its images: the Ada side of vision_c. It
--  only passes on; what is to be done with an image is decided above.

with Bytes;
with Options;
with Vision.Frame_Slots;
with Vision.Shapes; use Vision.Shapes;

package Vision.Library with
  SPARK_Mode,
  Abstract_State =>
    ((Camera with Synchronous, External => (Async_Readers, Async_Writers)),
     (Frames with Synchronous, External => (Async_Readers, Async_Writers)),
     (Memory with Synchronous, External => (Async_Readers, Async_Writers))),
  Initializes    => (Camera, Frames, Memory)
is

   --  Camera is the open source of images. It belongs to one task at a time,
   --  and so does each slot of Frames; two tasks may work on two slots at
   --  once. Memory is what is remembered of each calling task: the image that
   --  it has searched last, and why its last operation failed. Searching and
   --  encoding decode a slot's JPEG where nothing has needed its pixels. The
   --  first operation, Library_Version too, loads the libraries. No task is
   --  started, nothing is locked, nothing raises. OpenCV was seen to use up to
   --  52 kB of the calling task's stack.

   subtype Slot is Vision.Frame_Slots.Slot;
   --  A place for one image. What an operation needs is that the slot holds
   --  one: Bad_Argument where it never did.

   type Status is
     (Done,
      Not_Found,     --  nothing wrong: no arena, no robot
      No_Camera,     --  the source cannot be opened, or is not open
      No_Image,      --  the source delivered nothing usable
      Too_Small,     --  the buffer cannot hold the result
      Bad_Argument,
      Failed);       --  OpenCV failed inside, memory is exhausted, or the
                     --  camera's JPEG cannot be decoded

   subtype Side is Positive range 1 .. 8_192;
   --  Of an image, in pixels

   subtype Percentage is Positive range 1 .. 100;

   Max_Source : constant := 1_024;
   --  Characters in the name of a source

   subtype Reason_Text is String (1 .. 120);

   procedure Open
     (Source        : String;
      Width, Height : Side;
      Fps           : Positive;
      Result        : out Status)
   with
     Global => (In_Out => (Camera, Memory)),
     Pre    => Source'Length <= Max_Source,
     Post   => Result in Done | No_Camera | Bad_Argument | Failed;
   --  Opens a camera number, device path, file, URL or GStreamer pipeline.
   --  Images come scaled to fit Width x Height. What was open is closed
   --  first. Takes as long as the source does, 5 s at most for a URL (7 s
   --  where damaged images come). Of a source that has JPEG itself that is
   --  kept, and decoded in the first operation that needs pixels.

   procedure Grab (Into : Slot; Result : out Status)
   with
     Global => (In_Out => (Camera, Frames, Memory)),
     Post   => Result in Done | No_Camera | No_Image | Failed;
   --  Waits for the next image, 2 s at most (4 s where damaged ones come)
   --  where the source lets itself be interrupted. The slot keeps what it had
   --  unless Done. What a live source delivers waits in buffers and grows old
   --  there unless it is grabbed as fast as it comes.

   procedure Get_Format (Text : out Reason_Text; Last : out Natural)
   with
     Global => (Input => Camera),
     Post   => Last <= Text'Last;
   --  What the open source has granted, such as "MJPG 640x480, 30 a second":
   --  Text (1 .. Last), the rest blank; nothing for a still image

   procedure Close
   with Global => (In_Out => (Camera, Memory));
   --  Without effect where nothing is open

   procedure Find_Arena
     (In_Slot : Slot;
      Arena   : out Arena_Corners;
      Result  : out Status)
   with
     Global => (In_Out => (Frames, Memory)),
     Post   => Result in Done | Not_Found | Bad_Argument | Failed
       and then (if Result /= Done then Arena = No_Arena);

   procedure Find_Robots
     (In_Slot   : Slot;
      Marker    : Options.Marker_Kind;
      Arena     : Arena_Corners;
      Use_Arena : Boolean;
      Robots    : out Robot_Array;
      Count     : out Robot_Count;
      Result    : out Status)
   with
     Global => (In_Out => (Frames, Memory)),
     Post   => Result in Done | Not_Found | Bad_Argument | Failed
       and then (Result = Done) = (Count > 0);
   --  The robots in the image, lowest identifier first; inside Arena only
   --  where Use_Arena says so. To be called before anything is drawn: what is
   --  drawn hides what is searched.

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
   with
     Global => (In_Out => (Frames, Memory)),
     Post   => Result in Done | Not_Found | Bad_Argument | Failed
       and then (Result = Done) = (Count > 0);
   --  The robots in Areas (1 .. Number). None where anything else in the
   --  image, or in Arena, has changed since the calling task searched it
   --  last, with this or with Find_Robots

   procedure Draw_Arena
     (In_Slot : Slot;
      Arena   : Arena_Corners;
      Result  : out Status)
   with
     Global => (In_Out => (Frames, Memory)),
     Post   => Result in Done | Bad_Argument | Failed;

   procedure Draw_Robot
     (In_Slot : Slot;
      Item    : Robot;
      Result  : out Status)
   with
     Global => (In_Out => (Frames, Memory)),
     Post   => Result in Done | Bad_Argument | Failed;

   procedure Encode
     (From    : Slot;
      Quality : Percentage;
      Buffer  : in out Bytes.Byte_Array;
      Length  : out Natural;
      Result  : out Status)
   with
     Global => (In_Out => (Frames, Memory)),
     Post   => Result in Done | Too_Small | Bad_Argument | Failed
       and then Length <= Buffer'Length
       and then (Result = Done) = (Length > 0);
   --  The image as JPEG, in the first Length bytes of Buffer; those behind
   --  keep what they had. The camera's own bytes, of its own quality, where
   --  nothing has been drawn, the size is that asked for and any viewer takes
   --  them (vision_c/vision.h). Unless Done the buffer holds anything

   procedure Reason (Text : out Reason_Text; Last : out Natural)
   with
     Global => (Input => Memory),
     Post   => Last <= Text'Last;
   --  Why the last operation of the calling task was not Done, for the log:
   --  Text (1 .. Last), the rest blank

   procedure Library_Version (Text : out Reason_Text; Last : out Natural)
   with
     Global => (In_Out => Camera),
     Post   => Last <= Text'Last;
   --  The version of OpenCV, such as "4.6.0"

end Vision.Library;
