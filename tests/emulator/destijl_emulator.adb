--  SPDX-License-Identifier: GPL-3.0-or-later
--  The robot emulator: reads the command line, puts the robot on the bench,
--  opens its line and its camera, and waits for the end.

with Ada.Exceptions;
with Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;

with GNAT.OS_Lib;

with Arena_Camera;
with Bench_Console;
with Option_Readers;        use Option_Readers;
with Own_Process;
with Plain_Numbers;         use Plain_Numbers;
with Programs;
with Project_Version;
with Robot_Bench;           use Robot_Bench;
with Robot_Core;
with Serial_Side;
with Settings;              use Settings;
with Stop_Signals;

procedure Destijl_Emulator is

   NL : Character renames ASCII.LF;

   Usage : constant String :=
     "Usage: destijl_emulator [OPTION]..." & NL & NL
     & "The robot, on a pseudo-terminal whose path is the first line"
     & " printed." & NL
     & "Commands are read from standard input; 'help' lists them." & NL & NL
     & "  --link PATH          a symbolic link to the pseudo-terminal" & NL
     & "  --socket PATH        instead of it a socket, for tests" & NL
     & "  --baud N             pace of the bytes (9600; 0: no pacing)" & NL
     & "  --boot-ms N          start-up time of the robot (1600)" & NL
     & "  --stay-on            is switched on again whenever it is off" & NL
     & "  --radio              a pair of radios (XBee, transparent) is between"
     & NL
     & "                       line and robot; so with each --radio-..." & NL
     & "  --radio-seed N       of their random numbers (1)" & NL
     & "  --camera-port N      serves the arena camera on 127.0.0.1 (0: any)"
     & NL
     & "  --help               this text" & NL
     & "  --version" & NL & NL
     & "Commands, too, without the dashes:" & NL & NL
     & Settings.Names ("  --");

   Line        : Serial_Side.Choice;
   Boot        : Robot_Core.Tick_Count := Robot_Core.Boot_Ticks;
   Stay_On     : Boolean := False;
   With_Camera : Boolean := False;
   Port        : Natural := 0;
   --  Of the camera, 0: any free one
   Problem     : Unbounded_String;

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
   begin
      Programs.Give_Up ("destijl_emulator: " & Reason, Status);
   end Give_Up;

   procedure Set (Option : String) is
      --  One that the console has, too
      Known : Boolean;
      Word  : constant String := Option (Option'First + 2 .. Option'Last);
   begin
      Settings.Set
        (Word, (if Word in "silent" | "endless" | "charge" then "" else Value),
         Known);
      if not Known then
         Refuse;
      end if;
      Line.Radio := Line.Radio
        or else Ada.Strings.Fixed.Index (Option, "--radio") = 1;
   end Set;

   procedure Read_Command_Line is
   begin
      while Next loop
         if Name = "--link" or else Name = "--socket" then
            Line.Socket := Name = "--socket";
            Line.Link := To_Unbounded_String (Value);
            if Line.Link = "" then
               raise Bad_Value with "a path is expected";
            end if;
         elsif Name = "--baud" then
            Line.Baud := Number (0, Serial_Side.Baud_Rate'Last);
         elsif Name = "--boot-ms" then
            Boot := Natural'Max (1, (Number (0, 600_000) + 99) / 100);
         elsif Name = "--stay-on" then
            Stay_On := True;
         elsif Name = "--radio" then
            Line.Radio := True;
         elsif Name = "--radio-seed" then
            Line.Radio := True;
            Line.Seed := Number (0);
         elsif Name = "--camera-port" then
            With_Camera := True;
            Port := Number (0, 65_535);
         elsif Name = "--help" then
            Tell (Usage);
         elsif Name = "--version" then
            Tell ("destijl_emulator " & Project_Version.Number
                  & ", robot firmware 3.5");
         elsif Ada.Strings.Fixed.Index (Name, "--") = 1 then
            Set (Name);
         else
            Refuse;
         end if;
      end loop;
   exception
      when Problem : Bad_Value =>
         Give_Up (Name & ": " & Ada.Exceptions.Exception_Message (Problem)
                  & NL & NL & Usage, 2);
      when Problem : Bad_Usage =>
         Give_Up
           (Ada.Exceptions.Exception_Message (Problem) & NL & NL & Usage, 2);
   end Read_Command_Line;

begin
   Read_Command_Line;
   Own_Process.Lock_Memory;
   Own_Process.Ignore_Broken_Pipes;

   --  The camera first: where it fails there is no link to take back

   if With_Camera then
      Arena_Camera.Start (Port, Problem);
      if Problem /= "" then
         Give_Up ("no camera on 127.0.0.1:" & Image (Port) & ": "
                  & To_String (Problem), 1);
      end if;
   end if;

   Serial_Side.Start (Line, Problem);
   if Problem /= "" then
      Give_Up (To_String (Problem), 1);
   end if;

   Bench.Begin_Life (Boot, Stay_On);
   Bench_Console.Say ("device " & Serial_Side.Ask (Serial_Side.Name));
   if With_Camera then
      Bench_Console.Say
        ("camera http://127.0.0.1:" & Image (Port) & "/stream.mjpg");
   end if;
   Bench_Console.Start;

   Stop_Signals.Stop.Wait;
   Serial_Side.Stop;
   GNAT.OS_Lib.OS_Exit (0);
end Destijl_Emulator;
