--  SPDX-License-Identifier: GPL-3.0-or-later
--  The robot emulator: reads the command line, puts the robot on the bench,
--  opens its line and its camera, and waits for the end.

with Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;

with GNAT.OS_Lib;

with Arena_Camera;
with Bench_Console;
with Instants;              use Instants;
with Interfaces;
with Own_Process;
with Project_Version;
with Robot_Bench;           use Robot_Bench;
with Serial_Side;
with Settings;
with Stop_Signals;

procedure Destijl_Emulator is

   V       : Settings.Values;
   Wish    : Settings.Wish;
   Problem : Unbounded_String;
   Port    : Natural;

   --  An exception that left the main procedure would not end the process:
   --  it would wait for the tasks, for ever.

   procedure Tell (Text : String) is
      --  Ends the process, with status 1 where nobody can read Text
   begin
      Ada.Text_IO.Put_Line (Text);
      Ada.Text_IO.Flush;
      GNAT.OS_Lib.OS_Exit (0);
   exception
      when Ada.Text_IO.Device_Error =>
         GNAT.OS_Lib.OS_Exit (1);
   end Tell;

   procedure Give_Up (Reason : String; Status : Integer) is
      --  Ends the process with Status, whether Reason can be written or not
   begin
      Ada.Text_IO.Put_Line
        (Ada.Text_IO.Standard_Error, "destijl_emulator: " & Reason);
      GNAT.OS_Lib.OS_Exit (Status);
   exception
      when Ada.Text_IO.Device_Error =>
         GNAT.OS_Lib.OS_Exit (Status);
   end Give_Up;

begin
   Settings.Read_Command_Line (V, Wish, Problem);
   case Wish is
      when Settings.Show_Help =>
         Tell (Settings.Usage);
      when Settings.Show_Version =>
         Tell ("destijl_emulator " & Project_Version.Number
               & ", robot firmware 3.5");
      when Settings.Bad_Usage =>
         Give_Up
           (To_String (Problem) & ASCII.LF & ASCII.LF & Settings.Usage, 2);
      when Settings.Work =>
         null;
   end case;

   Own_Process.Lock_Memory;
   Own_Process.Ignore_Broken_Pipes;

   Bench.Place (V.Pose);
   Bench.Set_Wheels (V.Wheels);
   Bench.Set_Battery (V.Battery);
   Bench.Set_Charging (V.Charging);
   Bench.Set (Silent, Boolean'Pos (V.Silent));
   if V.Stay_On then
      Bench.Stay_On;
   end if;
   for Kind in Fault_Option loop
      Bench.Set (Kind, V.Faults (Kind));
   end loop;
   Bench.Set_Delay (Instant (V.Late) * 1_000_000);

   --  The camera first: where it fails there is no link to take back

   if V.With_Camera then
      Arena_Camera.Start (V.Camera_Port, V.Camera, Port, Problem);
      if Problem /= "" then
         Give_Up ("no camera on 127.0.0.1:"
                  & Ada.Strings.Fixed.Trim
                      (V.Camera_Port'Image, Ada.Strings.Left)
                  & ": " & To_String (Problem), 1);
      end if;
   end if;

   Serial_Side.Start (V.Baud, To_String (V.Link), V.Socket, V.Radio,
                      Interfaces.Unsigned_32 (V.Seed), Problem);
   if Problem /= "" then
      Give_Up (To_String (Problem), 1);
   end if;

   Bench.Switch_On (V.Boot);
   Bench_Console.Say ("device " & Serial_Side.Device);
   if V.With_Camera then
      Bench_Console.Say
        ("camera http://127.0.0.1:"
         & Ada.Strings.Fixed.Trim (Port'Image, Ada.Strings.Left)
         & "/stream.mjpg");
   end if;
   Bench_Console.Start;

   Stop_Signals.Stop.Wait;
   Serial_Side.Stop;
   GNAT.OS_Lib.OS_Exit (0);
end Destijl_Emulator;
