--  SPDX-License-Identifier: GPL-3.0-or-later
--  The stages of a session: their order, and that none begins at the end.

with AUnit.Assertions;       use AUnit.Assertions;

with Monitor.Session_Stages; use Monitor.Session_Stages;
with Unit_Runs; use Unit_Runs;

package body Session_Stages_Tests is

   procedure Test_Order is
      S        : State;
      Admitted : Boolean;
   begin
      Go_On (S, Closing);
      Assert (S.Stage = Free, "no session: none is lost");
      for Session in 1 .. 2 loop
         Begin_Active (S, Admitted);
         Assert (Admitted and then S.Stage = Active, "begun");
         Begin_Active (S, Admitted);
         Assert (not Admitted and then S.Stage = Active, "there is one");
         Go_On (S, Free);
         Assert (S.Stage = Active, "not brought back yet");
         Go_On (S, Closing);
         Begin_Active (S, Admitted);
         Assert (not Admitted and then S.Stage = Closing, "not yet");
         Go_On (S, Free);
         Assert (S.Stage = Free, "ended");
      end loop;
   end Test_Order;

   procedure Test_Stopping is
      S        : State;
      Admitted : Boolean;
   begin
      Begin_Active (S, Admitted);
      Stop (S);
      Go_On (S, Closing);
      Go_On (S, Free);
      Assert (S.Stage = Free, "a session ends");
      Begin_Active (S, Admitted);
      Assert (not Admitted and then S.Stage = Free, "but none begins");
   end Test_Stopping;

   procedure Add_Tests is
   begin
      Add_Test ("one stage after the other", Test_Order'Access);
      Add_Test ("none begins at the end", Test_Stopping'Access);
   end Add_Tests;

end Session_Stages_Tests;
