--  SPDX-License-Identifier: GPL-3.0-or-later
--  The command line: read once, before the server begins.

with Options;

package Command_Lines is

   type Request_Kind is (Run, Check, Show_Version, Show_Help, Wrong);

   procedure Read
     (Request : out Request_Kind; Chosen : out Options.Values);
   --  Wrong: Reason tells why

   function Reason return String;

   Usage : constant String;

   Version : constant String := "destijl 0.1.0";

private

   L : constant Character := ASCII.LF;

   Usage : constant String :=
     "Usage: destijl [OPTION ...]" & L
     & "Supervises a De Stijl robot for one monitor at a time." & L & L
     & "  --port N             port of the monitor (5544; 0: a free one)" & L
     & "  --bind ADDRESS       address to listen on (0.0.0.0)" & L
     & "  --serial PATH        serial line of the robot (/dev/ttyS0)" & L
     & "  --camera SOURCE      number, device, image or video file, URL or"
     & L
     & "                       GStreamer pipeline (0)" & L
     & "  --frame-size WxH     size of the images in pixels (640x480)" & L
     & "  --fps N              images a second, 1 .. 100 (10)" & L
     & "  --jpeg-quality N     1 .. 100 (80)" & L
     & "  --marker KIND        aruco or triangle (aruco)" & L
     & "  --message-gap MS     between two messages of which one is unasked,"
     & L
     & "                       0 .. 1000 (4)" & L
     & "  --log-level LEVEL    error, warning, info or debug (info)" & L
     & "  --check              say what would work, without starting" & L
     & "  --version, --help" & L & L
     & "Exit status: 0 after an orderly stop, 1 where the server cannot"
     & L
     & "start, 2 for bad usage, 3 after an internal failure.";

end Command_Lines;
