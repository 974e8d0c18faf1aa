--  SPDX-License-Identifier: GPL-3.0-or-later
--  Requirements that a fault checks during the session.

with Ada.Strings;           use Ada.Strings;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;

with Answer_Ledgers;        use Answer_Ledgers;
with Base64_Texts;
with Bytes;
with Expectations;          use Expectations;
with Jpeg_Headers;
with Tolerances;            use Tolerances;

package body Demands is

   Loss_Of_Robot : constant Duration := 1.0;
   --  F9: while the robot is started

   Reload_Period : constant Duration := 1.0;
   --  F11

   Images_Limit : constant Duration := 6.0;
   --  For one image more: ten a second, by programs of low priority

   function Asked (W : in out World; Command : String) return Reply is
      Start : Instant;
      Late  : Boolean;
   begin
      W.Expect_Answers;
      Start := Now;
      W.Say (Command);
      loop
         Late := Now > Start + Answer_Limit;
         Check (W.Present, "no session for " & Command);
         while W.Read < W.Monitor.Count loop
            W.Read := W.Read + 1;
            declare
               Item : constant Message := W.Monitor.Element (W.Read);
            begin
               Put_Message (W.Ledger, Item);
               if Is_Complete (W.Ledger) then
                  return (Item.Label, Item.Data, Item.Time - Start);
               end if;
            end;
         end loop;
         if W.Monitor.Closed_By_Peer (0.0) /= Open then
            W.Listen;
         end if;
         Check
           (not Is_Broken (W.Ledger),
            "not answered exactly once: " & Complaint (W.Ledger));
         Check (not Late, "no answer to " & Command);
         delay 0.001;
      end loop;
   end Asked;

   function Image (R : Reply) return String is
     (if Length (R.Data) = 0 then R.Label
      else R.Label & ":" & To_String (R.Data));

   procedure Expect (W : in out World; Command, Answers : String) is
      R : constant Reply := Asked (W, Command);
   begin
      Check
        (Index (" " & Answers & " ", " " & Image (R) & " ") > 0,
         Command & " was answered " & Image (R) & " instead of " & Answers);
      Check_Within (R.Took, Prompt + Noise, "the answer to " & Command);
   end Expect;

   procedure Quieten (W : in out World) is
   begin
      Expect (W, "ROPN", "AACK");
      Expect (W, "RRST", "AACK");

      --  a level that was held back for this answer may follow it

      delay 0.1;
      W.Listen;
      W.Robot := Line_Open;
   end Quieten;

   procedure Start_With_Watchdog (W : in out World) is
   begin
      if W.Robot not in Started_With_Watchdog | Moving_With_Watchdog then
         Quieten (W);
         Expect (W, "RSWW", "AACK");
         Expect (W, "RGLF", "AACK");
         W.Robot := Moving_With_Watchdog;
      end if;
   end Start_With_Watchdog;

   procedure Expect_Truth (W : in out World) is
      Level  : constant String := W.Emulator.Status ("battery");
      Before : constant String := W.Emulator.Status ("moving");
      R      : constant Reply := Asked (W, "RGST");
      After  : constant String := W.Emulator.Status ("moving");
   begin
      if Before = After then
         Check
           (Image (R) = "RCST:" & After,
            "RGST was answered " & Image (R) & ", but moving=" & After);
      end if;
      Expect
        (W, "RGBT", "RBLV:" & (if Level = "critical" then "0" else Level));
   end Expect_Truth;

   function Situation (W : in out World) return Before is
   begin
      W.Expect_Answers;
      return
        (Log   => W.Supervisor.Log_Length,
         Atims => W.Monitor.Count_Of ("ATIM"),
         Time  => Now);
   end Situation;

   procedure Expect_Loss (W : in out World; B : Before) is
      Deadline : constant Instant := B.Time + Loss_Of_Robot + Noise;
      Late     : Boolean;
   begin
      loop
         Late := Now > Deadline;
         W.Listen;
         exit when W.Monitor.Count_Of ("ATIM") > B.Atims;
         Check
           (not Late, "within 1 s nobody is told that the robot is lost");
         delay 0.005;
      end loop;
      W.Expect_Log ("robot lost", Within => Noise, After => B.Log);
      if W.Line_Works then
         loop
            Late := Now > Deadline + Noise;
            declare
               Last : constant String :=
                 To_String (W.Emulator.Journal.Last_Element.Command);
            begin
               exit when Last = "M=0";
               --  it may still be in transit, at 9600 baud
               Check (not Late, "the last word to a lost robot is " & Last);
            end;
            delay 0.005;
         end loop;
         W.Expect_Status
           ("moving", "0", Within => Stop_Limit + Noise);
      end if;
      Expect (W, "RPIN", "ANAK");
      Check
        (W.Monitor.Count_Of ("ATIM") = B.Atims + 1,
         "told more than once that the robot is lost");
   end Expect_Loss;

   procedure Expect_No_Loss (W : in out World; B : Before) is
   begin
      Check
        (not W.Supervisor.Says ("robot lost", After => B.Log),
         "the robot was given up after fewer than four failures");
   end Expect_No_Loss;

   procedure Await_Unasked (W : in out World) is
      On_Its_Way : constant Duration := 0.1;
   begin
      delay On_Its_Way;
      W.Listen;
   end Await_Unasked;

   procedure Expect_Return (W : in out World) is
   begin
      --  a line that is opened at once: system test F09_Reopened_At_Once
      Await_Unasked (W);
      Expect (W, "ROPN", "AACK");
      Expect (W, "RPIN", "AACK");
      W.Expect_Status ("moving", "0", Within => Stop_Limit + Noise);
      W.Robot := Line_Open;
   end Expect_Return;

   procedure Expect_Not_Running (W : in out World; B : Before) is
      Within : constant Duration := Reload_Period + Prompt + Noise;
      What   : constant String := "robot no longer runs";
      Late   : Boolean;
   begin
      W.Expect_Log (What, Within, After => B.Log);
      loop
         Late := Now > B.Time + Within + Noise;
         W.Listen;
         exit when
           (for some Number in reverse 1 .. W.Monitor.Count =>
              W.Monitor.Element (Number).Label = "MSSG"
              and then W.Monitor.Element (Number).Time > B.Time
              and then Index
                (To_String (W.Monitor.Element (Number).Data), What) > 0);
         Check (not Late, "the monitor is not told that the robot stands");
         delay 0.005;
      end loop;
      W.Emulator.Clear_Journal;
      Expect (W, "RGFW", "ACRJ");
      Check
        (W.Emulator.Wire_Text = "",
         "an order to a robot that is not started: " & W.Emulator.Wire_Text);
      W.Robot := Line_Open;
   end Expect_Not_Running;

   procedure Expect_Images (W : in out World; Count : Positive) is
      Before : constant Natural := W.Monitor.Count_Of ("CIMG");
      Start  : constant Instant := Now;
      Late   : Boolean;
   begin
      loop
         Late := Now - Start > Images_Limit + 0.1 * Count;
         W.Listen;
         exit when W.Monitor.Count_Of ("CIMG") >= Before + Count;
         Check
           (not Late,
            "in " & Milliseconds (Now - Start) & " came"
            & Integer'Image (W.Monitor.Count_Of ("CIMG") - Before)
            & " images");
         delay 0.005;
      end loop;
      Check (W.Monitor.Broken_Images = 0, "a broken image");
   end Expect_Images;

   procedure Expect_Closed (W : in out World; B : Before) is
      Within : constant Duration := 3.5;
      --  2.5 s without an image, and a little
      What   : constant String := "camera closed: ";
      Late   : Boolean;
   begin
      loop
         Late := Now > B.Time + Within + Noise;
         W.Listen;
         exit when
           (for some Number in reverse 1 .. W.Monitor.Count =>
              W.Monitor.Element (Number).Label = "MSSG"
              and then W.Monitor.Element (Number).Time > B.Time
              and then Index
                (To_String (W.Monitor.Element (Number).Data), What) > 0);
         Check (not Late, "nobody is told that the camera delivers nothing");
         delay 0.01;
      end loop;
   end Expect_Closed;

   procedure Expect_Open (W : in out World; B : Before) is
   begin
      Check
        (not W.Supervisor.Says ("camera closed", After => B.Log),
         "the camera was closed");
   end Expect_Open;

   procedure Get_Image_Size
     (W : in out World; Width, Height : out Natural)
   is
      Enough : constant := 2_000;
      --  Characters: the frame header comes before

      Text   : constant String := W.Monitor.Last_Image;
      Size   : constant Natural := Natural'Min (Enough, Text'Length) / 4 * 4;
      Data   : Bytes.Byte_Array (1 .. Enough) := (others => 0);
      Length : Natural;
      Done   : Boolean;
   begin
      Base64_Texts.Decode
        (Text (Text'First .. Text'First + Size - 1), Data, Length, Done);
      Check (Done, "an image that is no base64");
      Jpeg_Headers.Get_Size (Data (1 .. Length), Width, Height);
   end Get_Image_Size;

   procedure Recover_Camera (W : in out World) is
      Attempts : constant := 3;
      --  A late effect of the fault may close it once more
      Answer   : Reply;
   begin
      for Attempt in 1 .. Attempts loop
         Answer := Asked (W, "COPN");
         Check
           (Answer.Label = "AACK",
            "COPN was answered " & Image (Answer)
            & " though the camera works again");
         begin
            Expect_Images (W, 3);
            return;
         exception
            when Failed =>
               if Attempt = Attempts then
                  raise;
               end if;
         end;
      end loop;
   end Recover_Camera;

end Demands;
