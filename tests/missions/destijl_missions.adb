--  SPDX-License-Identifier: GPL-3.0-or-later
--  Carries out random missions, real and simulated, and prints one line of
--  JSON for each.

with Ada.Exceptions;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;           use Ada.Text_IO;
with GNAT.OS_Lib;

with Child_Processes;
with Emulators;
with Expectations;
with Host_Time;
with Judged_Simulations;
with Mission_Judges;
with Mission_Lines;         use Mission_Lines;
with Mission_Pictures;
with Mission_Plans;         use Mission_Plans;
with Option_Readers;        use Option_Readers;
with Own_Process;
with Plain_Numbers;         use Plain_Numbers;
with Programs;
with Real_Missions;
with Robot_Motion;
with Standstills;

procedure Destijl_Missions is

   Simulated : Natural  := 0;
   Real      : Natural  := 0;
   First     : Positive := 1;
   Step      : Positive := 1;
   Seed      : Natural  := 1;
   Radio     : Boolean  := False;
   Traced    : Boolean  := False;

   Picture, Journal, Pose, Order : Unbounded_String;

   Wheels : Robot_Motion.Wheel_Errors;

   Status : Integer := 0;

   procedure Say (Text : String) is
   begin
      Put_Line (Text);
      Flush;
   end Say;

   procedure Print_Usage (To : File_Type) is
   begin
      Put_Line (To, "usage: destijl_missions [OPTION]...");
      Put_Line (To, "   --simulated N   missions in simulated time (0)");
      Put_Line (To, "   --real N        missions of the supervisor (0)");
      Put_Line (To, "   --radio         these by radio");
      Put_Line (To, "   --picture FILE  draws one instead: SVG");
      Put_Line (To, "   --journal FILE  ... what the emulator has printed");
      Put_Line (To, "   --pose X,Y,A    ... where it stood: cm, degrees");
      Put_Line (To, "   --order MPCM:X;Y;...");
      Put_Line (To, "   --speed N --turn-speed N --overshoot N --pull N");
      Put_Line (To, "                   ... its wheels, as the emulator has");
      Put_Line (To, "   --seed N        others (1)");
      Put_Line (To, "   --trace         tells what happens, if simulated");
      Put_Line (To, "   --first N       the first one's number (1)");
      Put_Line (To, "   --step N        to the next one's number (1)");
      Put_Line (To, "   --supervisor PATH, --emulator PATH");
      Put_Line (To, "                   instead of those beside this one");
   end Print_Usage;

   procedure Read_Command_Line is
   begin
      while Next loop
         if Name = "--simulated" then
            Simulated := Number (0);
         elsif Name = "--real" then
            Real := Number (0);
         elsif Name = "--radio" then
            Radio := True;
         elsif Name = "--seed" then
            Seed := Number (0);
         elsif Name = "--picture" then
            Picture := To_Unbounded_String (Value);
         elsif Name = "--journal" then
            Journal := To_Unbounded_String (Value);
         elsif Name = "--pose" then
            Pose := To_Unbounded_String (Value);
         elsif Name = "--order" then
            Order := To_Unbounded_String (Value);
         elsif Name = "--trace" then
            Traced := True;
         elsif Name = "--speed" then
            Wheels.Speed := Number;
         elsif Name = "--turn-speed" then
            Wheels.Turn_Speed := Number;
         elsif Name = "--overshoot" then
            Wheels.Overshoot := Number (0);
         elsif Name = "--pull" then
            Wheels.Pull := Number (Integer'First);
         elsif Name = "--first" then
            First := Number;
         elsif Name = "--step" then
            Step := Number;
         elsif Programs.Read_Option then
            null;
         elsif Name = "--help" then
            Print_Usage (Standard_Output);
            GNAT.OS_Lib.OS_Exit (0);
         else
            Refuse;
         end if;
      end loop;
   end Read_Command_Line;

   procedure Draw is
      --  Status 1 where it is not as it should be
      P     : Plan := Read (To_String (Pose), To_String (Order));
      Notes : Emulators.Notes;
      V     : Mission_Judges.Verdict;
   begin
      P.Wheels := Wheels;
      Mission_Pictures.Read_Journal (To_String (Journal), Notes);
      if Notes.Is_Empty then
         raise Bad_Plan with "no journal in " & To_String (Journal);
      end if;
      Mission_Pictures.Draw (P, Notes, To_String (Picture), V);
      Put_Line
        (Image (V.Passed) & " of " & Image (P.Count) & " points passed, "
         & Rounded (Float (V.Pass), 1) & " mm from them at most, by "
         & Image (V.Orders) & " orders in " & Rounded (Float (V.Time), 1)
         & " s; exact turns and drives would take "
         & Rounded (Float (V.Exact), 1) & " s");
      if V.Wrong /= "" then
         Put_Line (To_String (V.Wrong));
         Status := 1;
      end if;
   end Draw;

   procedure Run_Real (Which : Positive) is
      --  Again where it misses a goal and the machine stood still meanwhile,
      --  as the system tests do
      Kind          : constant String := (if Radio then "radio" else "real");
      P             : Plan := Random (Seed, Which);
      Most_Repeated : constant := 11;
      Calm          : constant Duration := 60.0;
      Host_Before   : Duration;

      function Has_Stood_Still return Boolean is
        (Standstills.Longest >= Standstills.Too_Long
         or else Standstills.Longest_Line >= Standstills.Too_Long
         or else Host_Time.Taken - Host_Before >= Standstills.Too_Much);

   begin
      P.Radio := Radio;
      for Repeated in 0 .. Most_Repeated loop
         Standstills.Forget;
         Host_Before := Host_Time.Taken;
         declare
            V : Mission_Judges.Verdict;
         begin
            Real_Missions.Run (P, V);
            if Mission_Judges.Is_Good (V)
              or else not Has_Stood_Still
              or else Repeated = Most_Repeated
            then
               Say (Line (Kind, P, V, Repeated));
               return;
            end if;
         exception
            when Problem : Expectations.Failed =>
               if not Has_Stood_Still or else Repeated = Most_Repeated then
                  Say (Line
                    (Kind, P, Ada.Exceptions.Exception_Message (Problem)));
                  return;
               end if;
         end;
         Standstills.Await_Calm (Limit => Calm);
      end loop;
   end Run_Real;

   procedure Run_Simulated (P : Plan) is
      V : Mission_Judges.Verdict;
   begin
      Judged_Simulations.Run (P, V, Traced);
      Say (Line ("simulated", P, V));
   end Run_Simulated;

begin
   Own_Process.Ignore_Broken_Pipes;
   Read_Command_Line;
   if Picture /= "" then
      Draw;
   end if;
   for K in 0 .. Simulated - 1 loop
      Run_Simulated (Random (Seed, First + K * Step));
   end loop;
   if Real > 0 then
      Standstills.Watch (Lines => True);
   end if;
   for K in 0 .. Real - 1 loop
      Run_Real (First + K * Step);
   end loop;
   Programs.Remove_Temporary_Folder;
   GNAT.OS_Lib.OS_Exit (Status);

exception
   when Problem : Bad_Usage =>
      Put_Line
        (Standard_Error,
         "destijl_missions: " & Ada.Exceptions.Exception_Message (Problem));
      Print_Usage (Standard_Error);
      GNAT.OS_Lib.OS_Exit (2);
   when Problem : Bad_Plan =>
      Put_Line
        (Standard_Error,
         "destijl_missions: " & Ada.Exceptions.Exception_Message (Problem));
      GNAT.OS_Lib.OS_Exit (2);
   when Problem : others =>
      Child_Processes.Stop_All;
      Put_Line
        (Standard_Error,
         "destijl_missions: "
         & Ada.Exceptions.Exception_Information (Problem));
      Programs.Remove_Temporary_Folder;
      GNAT.OS_Lib.OS_Exit (1);
end Destijl_Missions;
