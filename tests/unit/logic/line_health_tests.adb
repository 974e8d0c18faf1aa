--  SPDX-License-Identifier: GPL-3.0-or-later
--  The robot's line: back into step after a failure.

with Bytes;
with Robot.Health;     use Robot.Health;
with Robot.Protocol;   use Robot.Protocol;
with Unit_Runs; use Unit_Runs;

procedure Line_Health_Tests is

   procedure Test_Late_Answers is
      use type Bytes.Byte;

      function Answer_Frame (Text : String) return Frame is
         --  Text with its checksum.
         F : Frame;
      begin
         for C of Text loop
            F.Length := F.Length + 1;
            F.Data (F.Length) := Character'Pos (C);
         end loop;
         F.Data (F.Length + 1) := Checksum (F.Data, F.Length);
         F.Length := F.Length + 1;
         return F;
      end Answer_Frame;

      H : State;
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
                  H := After_Failure (H, First);
                  for P in 1 .. Probes loop
                     Late (P) := Answer (Probe (H), Level);
                     Count := P;
                     H := After_Failure (H, Probe (H));
                  end loop;
                  Own := Probe (H);
                  for I in 0 .. Count loop
                     Assert
                       (not Is_Answer (Decode (Late (I), Own).Kind, Own),
                        "late answer");
                  end loop;
                  for C of String'("EE") loop
                     Assert
                       (not Is_Answer
                          (Decode (Answer_Frame ((1 => C)), Own).Kind, Own),
                        "late refusal");
                  end loop;
                  Assert
                    (Is_Answer (Decode (Answer (Own, Level), Own).Kind, Own),
                     "own answer");
               end;
            end loop;
         end loop;
      end loop;
   end Test_Late_Answers;

begin
   Run_Test ("a late answer never passes for the next",
             Test_Late_Answers'Access);
end Line_Health_Tests;
