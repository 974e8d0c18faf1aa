--  SPDX-License-Identifier: GPL-3.0-or-later

with AUnit.Assertions; use AUnit.Assertions;

with Unit_Runs;        use Unit_Runs;

procedure Process.Threads.Set_Tests is

   None : constant Set := (others => False);
   Four : constant Set := (0 .. 3 => True, others => False);
   Gaps : constant Set := (2 | 63 | 64 | 1_023 => True, others => False);
   One  : constant Set := (5 => True, others => False);

   procedure Test_Choice is
   begin
      Assert (Last_Of (Four) = 3, "the last of four");
      Assert (Last_Of (Gaps) = 1_023, "the last");
      Assert (Last_Of (None) = 0, "none is known");
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
end Process.Threads.Set_Tests;
