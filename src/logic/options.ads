--  SPDX-License-Identifier: GPL-3.0-or-later
--  What can be chosen on the command line, with the defaults.

with Admission.Networks;
with Monitor.Send_Order;
with Texts;

package Options with SPARK_Mode is

   type Marker_Kind is (Aruco, Triangle);

   type Drawing_Kind is (Nothing, Arena, All_Of_It);
   --  Over the images of the stream; All_Of_It: the robots, too. An arena that
   --  is to be confirmed is drawn always

   type Level is (Error, Warning, Info, Debug);
   --  Of the log, most serious first

   subtype Port_Number is Natural range 0 .. 65_535;
   subtype Pixel_Count is Positive range 16 .. 4_096;
   subtype Rate is Positive range 1 .. 100;
   subtype Percentage is Positive range 1 .. 100;
   subtype Milliseconds is Monitor.Send_Order.Milliseconds;

   subtype Processor is Natural range 0 .. 1_023;

   No_Processor   : constant := -1;
   Last_Processor : constant := -2;
   subtype Processor_Choice is Integer
     range Last_Processor .. Processor'Last;

   Camera_Rate : constant := 30;
   --  Images a second asked of a camera, or the rate of the images sent if
   --  that is higher: the newest is then never much older than 33 ms, and a
   --  camera whose clock drifts against ours misses no period

   type Values is record
      Port        : Port_Number  := 5_544;
      Bind        : Texts.Text   := Texts.To_Text ("0.0.0.0");
      Allowed     : Admission.Networks.List;
      --  whose monitors are admitted; none: everybody's
      Token_File  : Texts.Text;
      --  with the token that monitors must show; empty: none
      Serial      : Texts.Text   := Texts.To_Text ("/dev/ttyS0");
      Camera      : Texts.Text   := Texts.To_Text ("0");
      Width       : Pixel_Count  := 640;
      Height      : Pixel_Count  := 480;
      Frame_Rate  : Rate         := 10;          --  images a second
      Quality     : Percentage   := 80;          --  of the JPEG
      Marker      : Marker_Kind  := Aruco;
      Drawing     : Drawing_Kind := All_Of_It;
      Message_Gap : Milliseconds := 20;          --  PROTOCOL.md
      Log_Level   : Level        := Info;
      Cpu         : Processor_Choice := No_Processor;
      --  where the real-time tasks are kept; No_Processor: anywhere;
      --  Last_Processor: on the last that the process may run on
      Trace_File  : Texts.Text;
      --  for what the tasks did; empty: no trace
   end record;

end Options;
