--  SPDX-License-Identifier: GPL-3.0-or-later
--  The options of the command line, with their defaults.

with Missions;
with Networks;
with Schedule;
with Texts;

package Options with SPARK_Mode is

   type Marker_Kind is (Aruco, Triangle);

   type Drawing_Kind is (Nothing, Arena, All_Of_It);
   --  Drawn over the images of the stream; All_Of_It: the robots, too. An
   --  arena to be confirmed is always drawn

   type Level is (Error, Warning, Info, Debug);
   --  Levels of the log, most serious first

   function Name_Of (L : Level) return String is
     (case L is
         when Error   => "error",
         when Warning => "warning",
         when Info    => "info",
         when Debug   => "debug");

   subtype Port_Number is Natural range 0 .. 65_535;
   subtype Pixel_Count is Positive range 16 .. 4_096;
   subtype Rate is Positive range 1 .. 100;
   subtype Percentage is Positive range 1 .. 100;
   subtype Milliseconds is Natural range 0 .. 1_000;

   subtype Silence_Seconds is Natural range 0 .. 3_600;

   subtype Answer_Milliseconds is Positive range 20 .. 300;
   --  The shortest answer takes 10 ms; with 300 ms four failures in a row
   --  still take less than 2 s

   subtype Marker_Number is Natural range 0 .. 999;
   subtype Marker_Millimetres is Positive range 20 .. 140;
   Usual_Marker : constant Marker_Millimetres := 60;
   --  The black frame's side; the largest, with its margin, fits on A4

   subtype Processor is Natural range 0 .. 1_023;

   No_Processor   : constant := -1;
   Last_Processor : constant := -2;
   subtype Processor_Choice is Integer
     range Last_Processor .. Processor'Last;

   Camera_Rate : constant := 30;
   --  Images per second requested from the camera, or the rate of the images
   --  sent if that is higher. So the newest image is hardly older than 33 ms,
   --  and clock drift of the camera makes no period miss its image

   type Values is record
      Port        : Port_Number  := 5_544;
      Bind        : Texts.Text;
      --  the address to listen on; Command_Lines.Finish chooses it if it is
      --  not given
      Allowed     : Networks.List;
      --  networks whose monitors are admitted; empty: all
      Token_File  : Texts.Text;
      --  file with the token that monitors must send; empty: none
      Silence     : Silence_Seconds := 0;
      --  after which a monitor counts as lost; 0: never
      Serial      : Texts.Text   := Texts.To_Text ("/dev/ttyS0");
      Answer_Timeout : Answer_Milliseconds := Schedule.Answer_Timeout_Ms;
      --  of the robot, from the end of a command
      Camera      : Texts.Text   := Texts.To_Text ("0");
      Width       : Pixel_Count  := 640;
      Height      : Pixel_Count  := 480;
      Frame_Rate  : Rate         := 10;          --  images per second
      Quality     : Percentage   := 80;          --  of the JPEG
      Marker      : Marker_Kind  := Aruco;
      Drawing     : Drawing_Kind := All_Of_It;
      First_Marker : Marker_Number     := 0;     --  of the page to print
      Marker_Size  : Marker_Millimetres := Usual_Marker;
      Arena_Size  : Missions.Arena_Size;
      --  of the ground, in centimetres
      Message_Gap : Milliseconds := 20;          --  docs/wire.md
      Log_Level   : Level        := Info;
      Cpu         : Processor_Choice := No_Processor;
      --  the real-time tasks are pinned to it; No_Processor: not pinned;
      --  Last_Processor: the last that the process may run on
      Trace_File  : Texts.Text;
      --  for the trace; empty: no trace
   end record;

   function Is_Guarded (Chosen : Values) return Boolean is
     (Chosen.Allowed.Count > 0 or else Chosen.Token_File.Length > 0);
   --  Not everybody who reaches the server is admitted

   function Is_Local (Address : String) return Boolean is
     (Address = "::1"
      or else
        (Address'Length > 4
         and then Address (Address'First .. Address'First + 3) = "127."))
   with Pre => Address'First = 1;
   --  Only this machine reaches it

   function Admitted (Chosen : Values) return String is
     ((if Is_Local (Texts.Image (Chosen.Bind)) then "this machine alone"
       elsif Chosen.Allowed.Count > 0 then "the networks of --allow"
       else "every machine that reaches it")
      & (if Chosen.Token_File.Length > 0 then ", with the token" else ""));
   --  Who may connect, for the log

end Options;
