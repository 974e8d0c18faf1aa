--  SPDX-License-Identifier: GPL-3.0-or-later
--  Carries out random missions, real and simulated, and prints one line of
--  JSON for each.

with Ada.Exceptions;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;           use Ada.Text_IO;
with GNAT.OS_Lib;

with Expectations;
with Mission_Judges;        use Mission_Judges;
with Mission_Plans;         use Mission_Plans;
with Option_Readers;        use Option_Readers;
with Own_Process;
with Plain_Numbers;         use Plain_Numbers;
with Programs;
with Real_Missions;
with Reports;               use Reports;
with Simulated_Missions;
with Standstills;

procedure Destijl_Missions is

   Simulated : Natural  := 0;
   Real      : Natural  := 0;
   First     : Positive := 1;
   Step      : Positive := 1;
   Seed      : Natural  := 1;
   Least     : Point_Number := 5;
   Changing  : Natural  := 0;
   Radio     : Boolean  := False;

   procedure Say (Text : String) is
   begin
      Put_Line (Text);
      Flush;
   end Say;

   LF    : Character renames ASCII.LF;
   Usage : constant String :=
     "usage: destijl_missions [OPTION]..." & LF
     & "   --simulated N   missions in simulated time (0)" & LF
     & "   --real N        missions of the supervisor (0)" & LF
     & "   --radio         these by radio" & LF
     & "   --seed N        others (1)" & LF
     & "   --least N       through N to 12 points (5)" & LF
     & "   --changing N    speeds, from order to order, by N percent" & LF
     & "                   either way, if simulated (0)" & LF
     & "   --first N       the first one's number (1)" & LF
     & "   --step N        to the next one's number (1)" & LF
     & "   --supervisor PATH, --emulator PATH" & LF
     & "                   instead of those beside this one";

   function Line (Kind : String; P : Plan; Result : String) return String is
     ("{""kind"": " & Quoted (Kind) & ", ""number"": " & Image (P.Number)
      & ", ""faults"": " & (if P.Faulty then "true" else "false")
      & ", ""speed"": " & Image (P.Wheels.Speed)
      & ", ""turn_speed"": " & Image (P.Wheels.Turn_Speed)
      & ", ""overshoot"": " & Image (P.Wheels.Overshoot)
      & ", ""pull"": " & Image (P.Wheels.Pull)
      & ", ""points"": " & Image (P.Count) & Result & "}");
   --  As JSON

   function Result_Of (V : Verdict; Repeated : Natural := 0) return String is
     (", ""end"": "
      & Quoted (if V.Done then "done" else To_String (V.Reason))
      & ", ""time"": " & Rounded (Float (V.Time), 3)
      & ", ""exact"": " & Rounded (Float (V.Exact), 3)
      & ", ""passed"": " & Image (V.Passed)
      & ", ""pass"": "
      & (if V.Pass > 1_000.0 then "null" else Rounded (Float (V.Pass), 1))
      & ", ""clearance"": " & Rounded (Float (V.Clearance), 1)
      & ", ""blind"": " & Rounded (Float (V.Blind) * 1_000.0, 0)
      & ", ""orders"": " & Image (V.Orders)
      & ", ""repeated"": " & Image (Repeated)
      & ", ""wrong"": " & Quoted (To_String (V.Wrong)));

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
         elsif Name = "--first" then
            First := Number;
         elsif Name = "--step" then
            Step := Number;
         elsif Name = "--least" then
            Least := Number (1, 12);
         elsif Name = "--changing" then
            Changing := Number (0, 30);
         else
            Programs.Read_Option (Usage);
         end if;
      end loop;
   end Read_Command_Line;

   procedure Run_Real (Which : Positive) is
      --  Again where it misses a goal and the machine stood still meanwhile,
      --  as the system tests do
      Kind          : constant String := (if Radio then "radio" else "real");
      P             : Plan := Random (Seed, Which, Least);
      Most_Repeated : constant := 11;
      Calm          : constant Duration := 60.0;
      Host_Before   : Duration;
      Repeated      : Natural := 0;

      function Is_Final return Boolean is
        (not Standstills.Has_Stood_Still (Host_Before)
         or else Repeated = Most_Repeated);

   begin
      P.Radio := Radio;
      loop
         Standstills.Forget;
         Host_Before := Standstills.Taken_By_Host;
         declare
            V : Verdict;
         begin
            Real_Missions.Run (P, V);
            if Is_Good (V) or else Is_Final then
               Say (Line (Kind, P, Result_Of (V, Repeated)));
               return;
            end if;
         exception
            when Problem : Expectations.Failed | Expectations.Too_Late =>
               if Is_Final then
                  --  it could not be judged
                  Say
                    (Line
                       (Kind, P,
                        ", ""wrong"": " & Quoted
                          (Ada.Exceptions.Exception_Message (Problem))));
                  return;
               end if;
         end;
         Standstills.Await_Calm (Limit => Calm);
         Repeated := Repeated + 1;
      end loop;
   end Run_Real;

   procedure Run_Simulated (P : Plan) is
      R : Simulated_Missions.Result;
   begin
      Simulated_Missions.Simulate (P, R, Changing);
      Say (Line ("simulated", P, Result_Of (R.Verdict)));
   end Run_Simulated;

begin
   Own_Process.Ignore_Broken_Pipes;
   Read_Command_Line;
   for K in 0 .. Simulated - 1 loop
      Run_Simulated (Random (Seed, First + K * Step, Least));
   end loop;
   if Real > 0 then
      Standstills.Watch (Lines => True);
   end if;
   for K in 0 .. Real - 1 loop
      Run_Real (First + K * Step);
   end loop;
   Programs.Remove_Temporary_Folder;
   GNAT.OS_Lib.OS_Exit (0);

exception
   when Problem : others =>
      Programs.Give_Up (Problem);
end Destijl_Missions;
