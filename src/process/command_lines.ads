--  SPDX-License-Identifier: GPL-3.0-or-later
--  The command line: its arguments, read one by one, give a request and the
--  options of this run, or a reason for rejection. Also that of this run.

with Ada.Characters.Latin_1; use Ada.Characters.Latin_1;
with Options;
with Project_Version;
with Texts;

package Command_Lines with SPARK_Mode is

   pragma Elaborate_Body;

   use type Texts.Text;

   type Request_Kind is
     (Run, Check, Stop, Print_Markers, Show_Version, Show_Help, Wrong);

   subtype Settled_Kind is Request_Kind range Show_Version .. Wrong;
   --  Final: the rest of the command line does not change it

   type Option_Kind is
     (None, Port, Bind, Allow, Token, Silence, Serial, Answer_Timeout, Camera,
      Frame_Size, Frame_Rate, Quality, Marker, Drawing, Arena_Size,
      Message_Gap, Log_Level, Cpu, Trace, First_Marker, Marker_Size);

   type Reading is record
      Request : Request_Kind := Run;
      Chosen  : Options.Values;
      Reason  : Texts.Text;           --  of Wrong
      Awaited : Option_Kind := None;  --  the option whose value comes next
   end record;
   --  What has been read so far. Initially nothing, which is a valid command
   --  line

   procedure Take (R : in out Reading; Argument : String)
   with
     Pre  => Argument'First = 1,
     Post =>
       (if R.Request'Old in Settled_Kind then R.Request = R.Request'Old);
   --  The next argument: "--name", "--name=value", or the value of the name
   --  before it. A separate value does not begin with "--"

   procedure Finish (R : in out Reading)
   with
     Post => (if R.Request not in Settled_Kind then R.Awaited = None)
       and then (if R.Chosen.Bind.Length'Old > 0 then
                    R.Chosen.Bind = R.Chosen.Bind'Old
                 elsif not Options.Is_Guarded (R.Chosen) then
                    Texts.Image (R.Chosen.Bind) = "127.0.0.1");
   --  There are no more arguments. The server listens for this machine alone
   --  unless an address, networks or a token have been given

   Given : Reading with Constant_After_Elaboration;
   --  The command line of this run. Read at elaboration, before any task
   --  starts, so tasks read it without a lock

   Usage : constant String :=
     "Usage: destijl [OPTION ...]" & LF
     & "Supervises a De Stijl robot for one monitor at a time." & LF & LF
     & "  --port N             port of the monitor (5544; 0: a free one)" & LF
     & "  --bind ADDRESS       address to listen on (127.0.0.1, this machine;"
     & LF
     & "                       with --allow or --token 0.0.0.0, all)" & LF
     & "  --allow ADDRESS/LEN  admit monitors of this network only; up to 8"
     & LF
     & "                       times, for the monitors of any of them" & LF
     & "  --token FILE         admit monitors that begin with a line AUTH:"
     & LF
     & "                       and the token in the first line of FILE" & LF
     & "  --monitor-silence S  a monitor is lost that sends nothing for S"
     & LF
     & "                       seconds (0: never)" & LF
     & "  --serial PATH        serial line of the robot (/dev/ttyS0)" & LF
     & "  --answer-timeout MS  of the robot, 20 .. 300 (80, for a wire; by"
     & LF
     & "                       radio 150)" & LF
     & "  --camera SOURCE      number, device, image or video file, URL or"
     & LF
     & "                       GStreamer pipeline (0)" & LF
     & "  --frame-size WxH     size of the images in pixels (640x480)" & LF
     & "  --fps N              images a second, 1 .. 100 (10)" & LF
     & "  --jpeg-quality N     1 .. 100 (80)" & LF
     & "  --marker KIND        aruco or triangle (aruco)" & LF
     & "  --draw WHAT          over the images: all, arena or none (all)" & LF
     & "  --arena-size WxH     size of the arena in cm, for missions (80x60)"
     & LF
     & "  --message-gap MS     before an unsolicited message, 0 .. 1000 (20);"
     & LF
     & "                       before an answer 4 at most" & LF
     & "  --cpu N              keep the real-time tasks on processor N, or on"
     & LF
     & "                       the last one (auto), and all else off it" & LF
     & "  --log-level LEVEL    error, warning, info or debug (info)" & LF
     & "  --trace FILE         at the end, write to FILE what every task did"
     & LF
     & "  --check              say what would work, without starting" & LF
     & "  --stop               send the robot a stop, without starting" & LF
     & "  --print-markers ID   write a page of markers from ID on, as SVG; see"
     & LF
     & "                       'Markers' in the manual" & LF
     & "  --marker-size MM     side of their black frames, 20 .. 140 (60)"
     & LF
     & "  --version, --help" & LF & LF
     & "Exit status: 0 after an orderly stop, 1 where the server cannot"
     & LF
     & "start, the stop not be sent or the output is not taken, 2 for bad"
     & LF
     & "usage, 3 after an internal failure.";

   Version : constant String := "destijl " & Project_Version.Number;

end Command_Lines;
