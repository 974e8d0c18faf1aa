--  SPDX-License-Identifier: GPL-3.0-or-later
--  Whether the ledger verifies that every command is answered exactly once.

with AUnit.Assertions; use AUnit.Assertions;

with Answer_Ledgers;   use Answer_Ledgers;
with Instants;         use Instants;

package body Answer_Ledgers_Tests is

   subtype Any_Test is AUnit.Test_Cases.Test_Case'Class;

   L : Ledger;

   procedure Ask (Command : String);

   procedure Hear (Label : String);
   --  A message arrives now

   procedure Test_Once (T : in out Any_Test);
   procedure Test_Twice (T : in out Any_Test);
   procedure Test_Missing (T : in out Any_Test);
   procedure Test_Wrong_Kind (T : in out Any_Test);
   procedure Test_Too_Early (T : in out Any_Test);
   procedure Test_Unasked (T : in out Any_Test);
   procedure Test_Battery (T : in out Any_Test);
   procedure Test_Arena (T : in out Any_Test);
   procedure Test_Loss_Of_Robot (T : in out Any_Test);
   procedure Test_Silent (T : in out Any_Test);
   procedure Test_Perhaps (T : in out Any_Test);

   procedure Ask (Command : String) is
   begin
      Put_Command (L, Command, Kind_Of (Command));
   end Ask;

   procedure Hear (Label : String) is
   begin
      Put_Message (L, (Label => Label, Time => Now, others => <>));
   end Hear;

   overriding function Name (T : Test_Case) return AUnit.Message_String is
     (AUnit.Format ("Answer_Ledgers"));

   procedure Test_Once (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Clear (L);
      Assert (Is_Complete (L), "nothing asked");
      Ask ("RPIN");
      Ask ("RGST");
      Assert (not Is_Complete (L) and then Waiting (L) = 2, "two wait");
      Hear ("AACK");
      Assert (not Is_Complete (L) and then Waiting (L) = 1, "one waits");
      Assert (First_Waiting (L) = """RGST""", "which");
      Hear ("RCST");
      Assert (Is_Complete (L) and then Waiting (L) = 0, "none waits");
   end Test_Once;

   procedure Test_Twice (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Clear (L);
      Ask ("RPIN");
      Hear ("AACK");
      Hear ("AACK");
      Assert (Is_Broken (L), "the second answers nothing");
      Assert (not Is_Complete (L), "broken is not complete");
      Assert (Complaint (L) /= "", "a reason");
   end Test_Twice;

   procedure Test_Missing (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Clear (L);
      Ask ("RGST");
      Ask ("RPIN");
      Ask ("RPIN");
      Hear ("RCST");
      Hear ("AACK");
      Assert
        (not Is_Complete (L) and then not Is_Broken (L), "one is missing");
   end Test_Missing;

   procedure Test_Wrong_Kind (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Clear (L);
      Ask ("RPIN");
      Ask ("RGST");
      Hear ("RCST");
      Assert (Is_Broken (L), "out of their order");
      Clear (L);
      Put_Command (L, "rpin", Refused);
      Hear ("AACK");
      Assert (Is_Broken (L), "must be refused");
   end Test_Wrong_Kind;

   procedure Test_Too_Early (T : in out Any_Test) is
      pragma Unreferenced (T);
      Before : constant Instant := Now;
   begin
      Clear (L);
      delay 0.001;
      Ask ("RPIN");
      Put_Message (L, (Label => "AACK", Time => Before, others => <>));
      Assert (Is_Broken (L), "an answer before its command");
   end Test_Too_Early;

   procedure Test_Unasked (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Clear (L);
      Ask ("RPIN");
      Hear ("CIMG");
      Hear ("CPOS");
      Hear ("MSSG");
      Hear ("RBLV");
      Assert (Waiting (L) = 1, "no answers");
      Hear ("ANAK");
      Hear ("CIMG");
      Assert (Is_Complete (L), "answered once");
   end Test_Unasked;

   procedure Test_Battery (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      --  the unsolicited level comes first, the answer is a refusal
      Clear (L);
      Ask ("RGBT");
      Ask ("RPIN");
      Hear ("RBLV");
      Hear ("ANAK");
      Assert (not Is_Broken (L), "two readings");
      Hear ("ANAK");
      Assert (Is_Complete (L), "one of them is right");
      Hear ("ANAK");
      Assert (Is_Broken (L), "none is right");
      --  no level at all
      Clear (L);
      Ask ("RGBT");
      Ask ("RPIN");
      Hear ("AACK");
      Assert (not Is_Complete (L), "one is missing");
   end Test_Battery;

   procedure Test_Arena (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Clear (L);
      Hear ("CIMG");
      Ask ("CASA");
      Assert (not Is_Complete (L), "an image from before");
      Hear ("CIMG");
      Hear ("CIMG");
      Assert (Is_Complete (L) and then not Is_Broken (L), "an image");
      Ask ("CASA");
      Hear ("ANAK");
      Assert (Is_Complete (L), "no arena");
   end Test_Arena;

   procedure Test_Loss_Of_Robot (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Clear (L);
      Ask ("RPIN");
      Hear ("ATIM");
      Assert
        (Is_Complete (L) and then Unasked_Losses (L) = 0, "an answer");
      Hear ("ATIM");
      Assert
        (Is_Complete (L) and then Unasked_Losses (L) = 1, "and a loss");
      Ask ("RPIN");
      Hear ("ANAK");
      Assert
        (Is_Complete (L) and then Unasked_Losses (L) = 1, "still one");
   end Test_Loss_Of_Robot;

   procedure Test_Silent (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Clear (L);
      Ask ("CACO");
      Ask ("MSSG:text");
      Assert (Is_Complete (L), "no answer is due");
      Ask ("RPIN");
      Assert (Waiting (L) = 1, "one is");
      Hear ("AACK");
      Assert (Is_Complete (L), "it came");
      Ask ("CAIN");
      Hear ("AACK");
      Assert (Is_Broken (L), "an answer where none is due");
   end Test_Silent;

   procedure Test_Perhaps (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      for Answered in Boolean loop
         Clear (L);
         Put_Command (L, "MSSG:long", Perhaps);
         Ask ("RPIN");
         if Answered then
            Hear ("ACER");
         end if;
         Hear ("AACK");
         Assert (Is_Complete (L), "both are right");
         Hear ("ACER");
         Assert (Is_Broken (L), "but once");
      end loop;
   end Test_Perhaps;

   overriding procedure Register_Tests (T : in out Test_Case) is
      use AUnit.Test_Cases.Registration;
   begin
      Register_Routine (T, Test_Once'Access, "once");
      Register_Routine (T, Test_Twice'Access, "twice");
      Register_Routine (T, Test_Missing'Access, "missing");
      Register_Routine (T, Test_Wrong_Kind'Access, "of the wrong kind");
      Register_Routine (T, Test_Too_Early'Access, "too early");
      Register_Routine (T, Test_Unasked'Access, "unasked messages");
      Register_Routine (T, Test_Battery'Access, "battery");
      Register_Routine (T, Test_Arena'Access, "arena");
      Register_Routine (T, Test_Loss_Of_Robot'Access, "loss of the robot");
      Register_Routine (T, Test_Silent'Access, "no answer due");
      Register_Routine (T, Test_Perhaps'Access, "perhaps answered");
   end Register_Tests;

end Answer_Ledgers_Tests;
