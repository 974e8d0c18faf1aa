--  SPDX-License-Identifier: GPL-3.0-or-later
--  The token: its file, the line that shows it, and what the log shows.

with Ada.Strings.Fixed; use Ada.Strings.Fixed;

with Admission; use Admission;
with Texts;
with Unit_Runs; use Unit_Runs;

procedure Admission_Tests is

   LF : constant Character := ASCII.LF;
   CR : constant Character := ASCII.CR;

   procedure Expect_Shown (Line : String; Shown : String) is
      Text : Texts.Text := Texts.To_Text ("it: ");
   begin
      Append_Shown (Text, Line);
      Assert (Texts.Image (Text) = "it: " & Shown,
              Line & " is shown as " & Texts.Image (Text));
   end Expect_Shown;

   procedure Expect_Token (Text : String; Good : Boolean) is
      --  Of a file
      Known : Token;
   begin
      Read_Token (Head (Text, Text'Length), Known);
      Assert ((Known.Length > 0) = Good, "token: " & Text);
   end Expect_Token;

   procedure Test_Files is
      Least : constant String := "1234567890123456";
      Known : Token;
   begin
      Read_Token (Least & LF & "the rest" & LF, Known);
      Assert (Known.Data (1 .. Known.Length) = Least, "the first line");
      for Text of Split
        (Least & "|!!!!!!!!~~~~~~~~" & LF & "|" & (1 .. Max_Token => 'x') & LF
         & "|" & (1 .. Max_Token => 'x'))
      loop
         Expect_Token (Text, True);
      end loop;
      for Text of Split
        ("|" & LF & "|123456789012345|123456789012345" & LF & "6|" & LF
         & Least & LF & "|" & Least & " " & Least & LF & "| " & Least & LF
         & "|" & Least & " " & LF & "|" & Least & CR & LF & "|" & Least
         & ASCII.HT & Least & LF & "|" & Least & ASCII.NUL & Least & LF & "|"
         & Least & ASCII.DEL & Least & LF & "|" & Least
         & Character'Val (16#E9#) & Least & LF & "|"
         & (1 .. Max_Token + 1 => 'x') & LF & "|"
         & (1 .. Max_Token + 1 => 'x'))
      loop
         Expect_Token (Text, False);
      end loop;
   end Test_Files;

   procedure Test_Modes is
      type Modes is array (Positive range <>) of File_Mode;
   begin
      for Mode of Modes'(8#100600#, 8#100400#, 8#100711#) loop
         Assert (Is_Kept_Secret (Mode, 1000), "secret" & Mode'Image);
      end loop;
      for Mode of Modes'(8#100640#, 8#100620#, 8#100604#, 8#100602#) loop
         Assert (not Is_Kept_Secret (Mode, 1000), "not secret" & Mode'Image);
      end loop;
      Assert (Is_Kept_Secret (8#100440#, Root), "root's, a group reads");
      Assert (not Is_Kept_Secret (8#100460#, Root), "root's, a group writes");
      Assert (not Is_Kept_Secret (8#100444#, Root), "root's, others read");
   end Test_Modes;

   procedure Test_Shown is
      Whole : constant String := "--MSSG:AUTH:secret";
      Full  : Texts.Text := Texts.To_Text ((1 .. 500 => '.'));
   begin
      for Label of Split ("AUTH|xAUTH|auth|xAuTh|MSSG:AUTH|AUTAUTH") loop
         Expect_Shown (Label & ":secret", Label & ":...");
      end loop;
      Expect_Shown ("AUTH:", "AUTH:...");
      Expect_Shown ("AUTH:AUTH:secret", "AUTH:...");
      for Line of Split ("RPIN||AUTH|AUTH :x") loop
         Expect_Shown (Line, Line);
      end loop;
      Expect_Shown (Whole (8 .. Whole'Last), "AUTH:...");
      Expect_Shown (Whole (9 .. Whole'Last), "UTH:secret");
      Expect_Shown (Whole (8 .. 7), "");
      Append_Shown (Full, "0123456AUTH:secret");
      Assert (Full.Length = Texts.Max_Length
              and then Full.Data (501 .. 512) = "0123456AUTH:",
              "cut at its end: " & Texts.Image (Full));
   end Test_Shown;

begin
   Run_Test ("the file of a token", Test_Files'Access);
   Run_Test ("who may read it", Test_Modes'Access);
   Run_Test ("what the log shows", Test_Shown'Access);
end Admission_Tests;
