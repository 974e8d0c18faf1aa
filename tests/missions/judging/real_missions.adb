--  SPDX-License-Identifier: GPL-3.0-or-later
--  Missions of the real supervisor.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Emulators;
with Expectations;          use Expectations;
with Instants;              use Instants;
with Monitor_Clients;       use Monitor_Clients;
with Plain_Numbers;         use Plain_Numbers;
with Rigs;
with Robot_Motion;
with Robot_Truths;

package body Real_Missions is

   After_The_End : constant Duration := 0.3;
   --  The robot is still watched: it must rest, and nothing more be said

   By_Radio : constant Duration := 0.04;
   --  Of an exchange, at the median

   procedure Begin_Session (R : in out Rigs.Rig; P : Plan) is
      Unused : Message;
   begin
      Rigs.Play (R, Rigs.Guarded);
      R.Monitor.Expect ("COPN", "AACK");
      Rigs.Play (R, Rigs.Arena_Searched);
      R.Monitor.Send_Line ("CACO");
      R.Monitor.Expect ("CPCO", "AACK");
      loop
         Unused := R.Monitor.Next_Of ("CPOS");
         exit when Element (Unused.Data, 1) /= '-';
      end loop;
      if P.Faulty then
         R.Emulator.Tell ("drop-every" & Integer'Image (Drop_Every));
      end if;
      R.Emulator.Clear_Journal;
   end Begin_Session;

   procedure Compare (Truth : Emulators.Truth; Replayed : Robot_Motion.Pose) is
      --  Raises Failed unless they are the same
      Most : constant := 0.02;
      --  Centimetres, degrees

      function Differ (Centimetres : Float; Value : Micro) return Boolean is
        (abs (Centimetres - Float (Value) / 10_000.0) > Most);

      Turned : constant Float :=
        abs (Truth.Heading - Float (Replayed.Angle) / 1.0E6);
   begin
      Check (not Differ (Truth.X, Replayed.X)
             and then not Differ (Truth.Y, Replayed.Y)
             and then Float'Min (Turned, 360.0 - Turned) <= Most,
             "the robot is at " & Rounded (Truth.X) & " " & Rounded (Truth.Y)
             & ", by its journal at" & Replayed.X'Image & Replayed.Y'Image);
   end Compare;

   function Options (P : Plan) return String is
      --  Of the emulator

      function Decimals (Value, Unit : Micro) return String is
        (Rounded (Float (Value) / Float (Unit), 2));

   begin
      return (if P.Radio then "--radio" else "")
        & " --pose " & Decimals (P.Start.X, 10_000)
        & "," & Decimals (P.Start.Y, 10_000)
        & "," & Decimals (P.Start.Angle, 1_000_000)
        & (if not P.Faulty then ""
           else " --speed " & Image (P.Wheels.Speed)
                & " --turn-speed " & Image (P.Wheels.Turn_Speed)
                & " --overshoot " & Image (P.Wheels.Overshoot)
                & " --pull " & Image (P.Wheels.Pull)
                & " --camera-delay " & Image (Camera_Delay)
                & " --position-noise " & Image (Displacement));
   end Options;

   procedure Run (P : Plan; V : out Verdict) is
      R      : Rigs.Rig;
      J      : Judge;
      Begun  : Instant;
      Ended  : Message;
      Next   : Positive;
      Last   : Robot_Motion.Pose;
      Drives : Boolean := False;
      Busy   : Duration;

      procedure See_Pose
        (Time : Instant; Where : Robot_Motion.Pose; Driving : Boolean) is
      begin
         while Next <= R.Monitor.Count
           and then R.Monitor.Element (Next).Time <= Time
         loop
            declare
               M : constant Message := R.Monitor.Element (Next);
            begin
               if M.Label = "CPOS" and then Element (M.Data, 1) /= '-' then
                  See_Position (J, M.Time - Begun);
               end if;
            end;
            Next := Next + 1;
         end loop;
         See_Pose (J, Time - Begun, Where, Driving);
         Last := Where;
         Drives := Driving;
      end See_Pose;

   begin
      Rigs.Assemble (R, Camera => True, Emulator_Options => Options (P),
                     Supervisor_Options =>
                       (if P.Radio then "--answer-timeout 150" else ""));
      Begin_Session (R, P);
      Next := Integer'Max (1, R.Monitor.Count);
      --  The last position before the order is one of the newest messages
      for Number in reverse 1 .. R.Monitor.Count loop
         Next := Number;
         exit when R.Monitor.Element (Number).Label = "CPOS";
      end loop;
      Begun := Now;
      R.Monitor.Expect (Order (P), "AACK");
      loop
         Ended := R.Monitor.Next_Of ("MPRG MEND");
         exit when Ended.Label = "MEND";
      end loop;
      R.Monitor.Expect_Silence ("MEND MPRG", For_Time => After_The_End);
      declare
         Notes : constant Emulators.Notes := R.Emulator.Journal;
      begin
         if P.Radio then
            Busy := Natural (Notes.Length) * By_Radio
              / Duration'(Ended.Time + After_The_End - Begun);
            Check (Busy <= 0.5, "of the line's time" & Busy'Image);
         end if;
         Start (J, P);
         Robot_Truths.Replay
           (Notes, P.Start, P.Wheels, Begun, Ended.Time + After_The_End,
            See_Pose'Access);
         Conclude (J, P, To_String (Ended.Data), Ended.Time - Begun,
                   Robot_Truths.Movements (Notes), V);
      end;
      --  Its watchdog, too, may have stopped the robot
      Check (not Drives or else R.Emulator.Status ("moving") = "1",
             "the robot has stopped without an order; the mission's end: "
             & To_String (Ended.Data));
      if not Drives then
         Compare (R.Emulator.Pose, Last);
      end if;
   end Run;

end Real_Missions;
