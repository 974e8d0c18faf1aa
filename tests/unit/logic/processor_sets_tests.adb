--  SPDX-License-Identifier: GPL-3.0-or-later

with AUnit.Assertions; use AUnit.Assertions;

with Options;
with Processor_Sets;   use Processor_Sets;
with Unit_Runs; use Unit_Runs;

procedure Processor_Sets_Tests is

   None : constant Set := (others => False);
   Four : constant Set := (0 .. 3 => True, others => False);
   Gaps : constant Set := (2 | 63 | 64 | 1_023 => True, others => False);
   One  : constant Set := (5 => True, others => False);

   procedure Test_Choice is
   begin
      Assert (Chosen (Four, Options.Last_Processor) = 3, "the last of four");
      Assert (Chosen (Gaps, Options.Last_Processor) = 1_023, "the last");
      Assert (Chosen (None, Options.Last_Processor) = 0, "none is known");
      Assert (Chosen (Four, 7) = 7, "a number");
      Assert (Chosen (Four, Options.No_Processor) = Options.No_Processor,
              "no choice");
      Assert (May_Have (Four, 3) and then not May_Have (Four, 4)
              and then not May_Have (None, 0), "those allowed");
      Assert (May_Have (None, Options.No_Processor), "no choice is allowed");
      Assert (Is_Alone (One) and then not Is_Alone (Four)
              and then not Is_Alone (None), "one alone");
   end Test_Choice;

   procedure Test_Division is
      Sets : Division;
   begin
      Assert (Set'Size = 1_024, "the size of cpu_set_t");
      Divide (Four, 1, Sets);
      Assert (Sets (True) = Set'(1 => True, others => False)
              and then Sets (False) = (Four and not Sets (True)), "of four");
      Divide (Gaps, 64, Sets);
      Assert (Sets (True) = Set'(64 => True, others => False)
              and then Sets (False)
                = Set'(2 | 63 | 1_023 => True, others => False), "of gaps");
      Divide (One, 5, Sets);
      Assert (Sets (True) = One and then Sets (False) = One, "of one");
   end Test_Division;

begin
   Run_Test ("the one that is meant", Test_Choice'Access);
   Run_Test ("who has which", Test_Division'Access);
end Processor_Sets_Tests;
