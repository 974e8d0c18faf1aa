--  SPDX-License-Identifier: GPL-3.0-or-later
--  Whether the ledger verifies that every command is answered exactly once.

with AUnit.Assertions; use AUnit.Assertions;

with Answer_Ledgers;   use Answer_Ledgers;
with Instants;         use Instants;
with Unit_Runs; use Unit_Runs;

procedure Answer_Ledgers_Tests is

   L : Ledger;

   procedure Ask (Command : String) is
   begin
      Put_Command (L, Command, Kind_Of (Command));
   end Ask;

   procedure Hear (Label : String) is
      --  A message arrives now
   begin
      Put_Message (L, (Label => Label, Time => Now, others => <>));
   end Hear;

   procedure Test_Once is
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

   procedure Test_Twice is
   begin
      Clear (L);
      Ask ("RPIN");
      Hear ("AACK");
      Hear ("AACK");
      Assert (Is_Broken (L), "the second answers nothing");
      Assert (not Is_Complete (L), "broken is not complete");
      Assert (Complaint (L) /= "", "a reason");
   end Test_Twice;

   procedure Test_Missing is
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

   procedure Test_Wrong_Kind is
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

   procedure Test_Too_Early is
      Before : constant Instant := Now;
   begin
      Clear (L);
      delay 0.001;
      Ask ("RPIN");
      Put_Message (L, (Label => "AACK", Time => Before, others => <>));
      Assert (Is_Broken (L), "an answer before its command");
   end Test_Too_Early;

   procedure Test_Unasked is
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

   procedure Test_Battery is
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

   procedure Test_Arena is
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

   procedure Test_Loss_Of_Robot is
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

   procedure Test_Silent is
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

   procedure Test_Perhaps is
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

begin
   Run_Test ("once", Test_Once'Access);
   Run_Test ("twice", Test_Twice'Access);
   Run_Test ("missing", Test_Missing'Access);
   Run_Test ("of the wrong kind", Test_Wrong_Kind'Access);
   Run_Test ("too early", Test_Too_Early'Access);
   Run_Test ("unasked messages", Test_Unasked'Access);
   Run_Test ("battery", Test_Battery'Access);
   Run_Test ("arena", Test_Arena'Access);
   Run_Test ("loss of the robot", Test_Loss_Of_Robot'Access);
   Run_Test ("no answer due", Test_Silent'Access);
   Run_Test ("perhaps answered", Test_Perhaps'Access);
end Answer_Ledgers_Tests;
