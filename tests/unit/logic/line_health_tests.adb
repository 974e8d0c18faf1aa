--  SPDX-License-Identifier: GPL-3.0-or-later
--  The robot's line: lost at the fourth failure, and back into step.

with AUnit.Assertions; use AUnit.Assertions;

with Bytes;
with Robot.Health;     use Robot.Health;
with Robot.Protocol;   use Robot.Protocol;
with Unit_Runs; use Unit_Runs;

package body Line_Health_Tests is

   Visited : Natural := 0;

   procedure Explore (H : State; Depth : Natural) is
      --  All that can happen next: every command, every probe, fail or not.
      Next : State;
   begin
      Visited := Visited + 1;
      Assert (Lost (H) = (Failures (H) = 4), "lost at four");
      if Lost (H) or else Depth = 0 then
         return;
      end if;
      if In_Step (H) then
         Assert ((for all C in Answer_Class => not Is_Owed (H, C)),
                 "nothing is owed in step");
         for K in Command_Kind loop
            Next := H;
            Failure (Next, K);
            Assert (not In_Step (Next)
                    and then Failures (Next) = 1
                    and then (for all C in Answer_Class =>
                                Is_Owed (Next, C) = (C = Class_Of (K))),
                    "one failure, one class owed");
            Explore (Next, Depth - 1);
         end loop;
      else
         Assert (not Is_Owed (H, Class_Of (Probe (H))), "probe is free");
         Next := H;
         Failure (Next, Probe (H));
         Assert (Failures (Next) = Failures (H) + 1
                 and then Is_Owed (Next, Class_Of (Probe (H))),
                 "a failed probe counts and is owed");
         Explore (Next, Depth - 1);
      end if;
      Next := H;
      Success (Next);
      Assert (In_Step (Next) and then Failures (Next) = 0, "success");
      Explore (Next, Depth - 1);
   end Explore;

   procedure Test_Explore is
   begin
      Visited := 0;
      Explore (Initial, 8);
      Explore (Opened, 4);
      Assert (Visited > 10_000, "states visited");
   end Test_Explore;

   procedure Test_Fourth is
   begin
      for First in Command_Kind loop
         declare
            H : State;
         begin
            Failure (H, First);
            Assert (not Lost (H), "first");
            Failure (H, Probe (H));
            Assert (not Lost (H), "second");
            Failure (H, Probe (H));
            Assert (not Lost (H), "third");
            Failure (H, Probe (H));
            Assert (Lost (H), "fourth");
         end;
      end loop;
   end Test_Fourth;

   procedure Test_Initial is
      H : State;
   begin
      Assert (H = Initial and then In_Step (H) and then not Lost (H),
              "in step");
      Assert ((for all C in Answer_Class => not Is_Owed (H, C)),
              "nothing is owed");
      H := Opened;
      Assert (Failures (H) = 0 and then not In_Step (H)
              and then Probe (H) = Version,
              "just opened: something may still be on its way");
      Success (H);
      Assert (H = Initial, "nothing any more");
      H := Opened;
      Failure (H, Version);
      Assert (Failures (H) = 1 and then Is_Owed (H, Text)
              and then Probe (H) = Battery,
              "a failure counts");
   end Test_Initial;

   procedure Test_Late_Answers is
      use type Bytes.Byte;

      function Answer_Frame (Text : String) return Frame is
         --  Text with its checksum and terminator.
         F : Frame;
      begin
         for C of Text loop
            F.Length := F.Length + 1;
            F.Data (F.Length) := Character'Pos (C);
         end loop;
         F.Data (F.Length + 1) := Checksum (F.Data, F.Length);
         F.Data (F.Length + 2) := Terminator;
         F.Length := F.Length + 2;
         return F;
      end Answer_Frame;

      H : State;
      R : Reply;

      Nothing : constant Frame := (Length => 0, others => <>);

      function Answer (Kind : Command_Kind; Level : Natural) return Frame is
        (case Class_Of (Kind) is
            when Acknowledge => Answer_Frame ("O"),
            when Digit       => (case Level is
                                   when 0      => Answer_Frame ("0"),
                                   when 1      => Answer_Frame ("1"),
                                   when others => Answer_Frame ("2")),
            when Text        => Answer_Frame ("3.5"),
            when Unknown     => Answer_Frame ("C"));
      --  What the robot says when it understands; Level its battery, 0 or
      --  1 whether it is busy.

   begin
      --  Whatever fails, and whatever any of it is answered in the end,
      --  none of the late answers is taken for the probe's own, which is.

      for First in Command_Kind loop
         for Probes in 0 .. 2 loop
            for Level in 0 .. 2 loop
               H := Initial;
               declare
                  Late  : array (0 .. 2) of Frame := (others => Nothing);
                  Count : Natural := 0;
                  Own   : Command_Kind;
               begin
                  Late (0) := Answer (First, Level);
                  Failure (H, First);
                  for P in 1 .. Probes loop
                     Late (P) := Answer (Probe (H), Level);
                     Count := P;
                     Failure (H, Probe (H));
                  end loop;
                  Own := Probe (H);
                  for I in 0 .. Count loop
                     Decode (Late (I), Own, R);
                     Assert (not Is_Answer (R.Kind, Own), "late answer");
                  end loop;
                  for C of String'("EE") loop
                     Decode (Answer_Frame ((1 => C)), Own, R);
                     Assert (not Is_Answer (R.Kind, Own), "late refusal");
                  end loop;
                  Decode (Answer (Own, Level), Own, R);
                  Assert (Is_Answer (R.Kind, Own), "own answer");
                  Success (H);
                  Assert (In_Step (H), "in step again");
               end;
            end loop;
         end loop;
      end loop;
   end Test_Late_Answers;

   procedure Test_Probe_Order is
      H : State;
   begin
      Failure (H, Move);
      Assert (Probe (H) = Version, "first");
      Failure (H, Version);
      Assert (Probe (H) = Battery, "second");
      Failure (H, Battery);
      Assert (Probe (H) = Unknown_Letter, "third");
      H := Initial;
      Failure (H, Version);
      Failure (H, Battery);
      Failure (H, Unknown_Letter);
      Assert (Probe (H) = Ping, "where only an acknowledgement is free");
      H := Initial;
      Failure (H, Busy);
      Assert (Probe (H) = Version, "after a digit");
      Failure (H, Version);
      Assert (Probe (H) = Unknown_Letter, "no digit after a digit");
   end Test_Probe_Order;

   procedure Test_Reset is
      H : State;
   begin
      for Round in 1 .. 10 loop
         Failure (H, Ping);
         Failure (H, Probe (H));
         Failure (H, Probe (H));
         Assert (Failures (H) = 3 and then not Lost (H), "three");
         Success (H);
         Assert (Failures (H) = 0 and then In_Step (H), "none");
      end loop;
   end Test_Reset;

   procedure Add_Tests is
   begin
      Add_Test ("a line just opened", Test_Initial'Access);
      Add_Test ("F8: lost at the fourth failure, not the third",
                Test_Fourth'Access);
      Add_Test ("F8: any success resets the count", Test_Reset'Access);
      Add_Test ("order of the probes", Test_Probe_Order'Access);
      Add_Test ("everything, eight deep", Test_Explore'Access);
      Add_Test ("a late answer never passes for the next",
                Test_Late_Answers'Access);
   end Add_Tests;

end Line_Health_Tests;
