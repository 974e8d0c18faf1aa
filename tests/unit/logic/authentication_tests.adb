--  SPDX-License-Identifier: GPL-3.0-or-later
--  The token: its file, the line that shows it, and what the log shows.

with AUnit.Assertions;         use AUnit.Assertions;

with Admission.Authentication; use Admission.Authentication;
with Texts;
with Unit_Runs; use Unit_Runs;

package body Authentication_Tests is

   LF : constant Character := ASCII.LF;
   CR : constant Character := ASCII.CR;

   Usual : constant String := "correct-horse-battery";

   function To_Token (Text : String) return Token is
      --  A good one
   begin
      return Result : Token do
         Read_Token (Text, Result);
         Assert (Result.Length > 0, "no token: " & Text);
      end return;
   end To_Token;

   procedure Expect
     (Text : String; Outcome : Verdict; Of_Token : String := Usual)
   is
      --  After all of Text, or where it is decided before
      Known : constant Token := To_Token (Of_Token);
      R     : Reader;
   begin
      for C of Text loop
         Assert
           (Decision (R, Known) = Undecided, "decided too early: " & Text);
         R.Length := R.Length + 1;
         R.Data (R.Length) := C;
      end loop;
      Assert
        (Decision (R, Known) = Outcome,
         Decision (R, Known)'Image & " after " & Text);
   end Expect;

   procedure Expect_Shown (Line : String; Shown : String) is
      Text : Texts.Text := Texts.To_Text ("it: ");
   begin
      Append_Shown (Text, Line);
      Assert
        (Texts.Image (Text) = "it: " & Shown,
         Line & " is shown as " & Texts.Image (Text));
   end Expect_Shown;

   procedure Expect_Token (Text : String; Good : Boolean) is
      --  Of a file
      Known : Token;
   begin
      Read_Token (Text, Known);
      Assert ((Known.Length > 0) = Good, "token: " & Text);
   end Expect_Token;

   procedure Test_Every_Place is

      procedure Try (Of_Token : String) is
         Line : constant String := "AUTH:" & Of_Token;
         Bad  : String (1 .. Line'Length);
      begin
         Expect (Line & LF, Right, Of_Token);
         Expect (Line & CR & LF, Right, Of_Token);
         for I in Line'Range loop
            --  each single bit: none may be left out of the comparison
            for Bit in 0 .. 7 loop
               Bad := Line;
               Bad (I) := Character'Val
                 (if Character'Pos (Line (I)) / 2 ** Bit mod 2 = 0
                  then Character'Pos (Line (I)) + 2 ** Bit
                  else Character'Pos (Line (I)) - 2 ** Bit);
               if Bad (I) /= LF then
                  Expect (Bad & LF, Wrong, Of_Token);
               end if;
            end loop;
            Expect (Line (1 .. I - 1) & LF, Wrong, Of_Token);
            Expect
              (Line (1 .. I - 1) & Line (I + 1 .. Line'Last) & LF, Wrong,
               Of_Token);
         end loop;
      end Try;

   begin
      Try ((1 .. Min_Token => 'x'));
      Try (Usual);
      Try ((1 .. Max_Token - 1 => '!', Max_Token => '~'));
   end Test_Every_Place;

   procedure Test_Files is
      Least : constant String := "1234567890123456";
      Known : Token;
   begin
      Read_Token (Least & LF & "the rest" & LF, Known);
      Assert (Known.Data (1 .. Known.Length) = Least, "the first line");
      Expect_Token (Least, True);
      Expect_Token (Least (1 .. 15) & LF & "6", False);
      Expect_Token (Least (1 .. 15), False);
      Expect_Token ("", False);
      Expect_Token ((1 => LF), False);
      Expect_Token (LF & Least & LF, False);
      Expect_Token (Least & " " & Least & LF, False);
      Expect_Token (" " & Least & LF, False);
      Expect_Token (Least & " " & LF, False);
      Expect_Token (Least & CR & LF, False);
      Expect_Token (Least & ASCII.HT & Least & LF, False);
      Expect_Token (Least & ASCII.NUL & Least & LF, False);
      Expect_Token (Least & ASCII.DEL & Least & LF, False);
      Expect_Token (Least & Character'Val (16#E9#) & Least & LF, False);
      Expect_Token ("!!!!!!!!~~~~~~~~" & LF, True);
      Expect_Token ((1 .. Max_Token => 'x') & LF, True);
      Expect_Token ((1 .. Max_Token => 'x'), True);
      Expect_Token ((1 .. Max_Token + 1 => 'x') & LF, False);
      Expect_Token ((1 .. Max_Token + 1 => 'x'), False);
   end Test_Files;

   procedure Test_Modes is
   begin
      Assert (Is_Kept_Secret (8#100600#, 1000), "rw-------");
      Assert (Is_Kept_Secret (8#100400#, 1000), "r--------");
      Assert
        (Is_Kept_Secret (8#100711#, 1000), "may run it, whatever that is");
      Assert (not Is_Kept_Secret (8#100640#, 1000), "group reads");
      Assert (not Is_Kept_Secret (8#100620#, 1000), "group writes");
      Assert (not Is_Kept_Secret (8#100604#, 1000), "others read");
      Assert (not Is_Kept_Secret (8#100602#, 1000), "others write");
      Assert (not Is_Kept_Secret (8#100666#, 1000), "everybody");
      Assert (Is_Kept_Secret (8#100440#, Root), "root's, a group reads");
      Assert (not Is_Kept_Secret (8#100460#, Root), "root's, a group writes");
      Assert (not Is_Kept_Secret (8#100444#, Root), "root's, others read");
   end Test_Modes;

   procedure Test_Right is
   begin
      Expect ("AUTH:" & Usual, Undecided);
      Expect ("AUTH:" & Usual & CR, Undecided);
      Expect ("AUTH:" & Usual & LF, Right);
      Expect ("AUTH:" & Usual & CR & LF, Right);
      Expect ("", Undecided);
   end Test_Right;

   procedure Test_Shown is
      Whole : constant String := "--MSSG:AUTH:secret";
      Full  : Texts.Text := Texts.To_Text ((1 .. 500 => '.'));
   begin
      Expect_Shown ("AUTH:secret", "AUTH:...");
      Expect_Shown ("AUTH:", "AUTH:...");
      Expect_Shown ("AUTH:AUTH:secret", "AUTH:...");
      Expect_Shown ("xAUTH:secret", "xAUTH:...");
      Expect_Shown ("auth:secret", "auth:...");
      Expect_Shown ("xAuTh:secret", "xAuTh:...");
      Expect_Shown ("MSSG:AUTH:secret", "MSSG:AUTH:...");
      Expect_Shown ("AUTAUTH:secret", "AUTAUTH:...");
      Expect_Shown ("RPIN", "RPIN");
      Expect_Shown ("", "");
      Expect_Shown ("AUTH", "AUTH");
      Expect_Shown ("AUTH :x", "AUTH :x");
      Expect_Shown (Whole (8 .. Whole'Last), "AUTH:...");
      Expect_Shown (Whole (9 .. Whole'Last), "UTH:secret");
      Expect_Shown (Whole (8 .. 7), "");
      Append_Shown (Full, "0123456AUTH:secret");
      Assert
        (Full.Length = Texts.Max_Length
         and then Full.Data (501 .. 512) = "0123456AUTH:",
         "cut at its end: " & Texts.Image (Full));
   end Test_Shown;

   procedure Test_Too_Long is
      Longest : constant String := (1 .. Max_Token => 'x');
   begin
      Expect ("AUTH:" & Longest & "xx", Wrong);
      Expect ("AUTH:" & Longest & "x" & LF, Wrong);
      Expect ("AUTH:" & Longest & CR & CR, Wrong);
      Expect ((1 .. Max_Line - 1 => 'x'), Undecided);
      Expect ((1 .. Max_Line => 'x'), Wrong);
      Expect ((1 .. Max_Line => ASCII.NUL), Wrong);
      Expect ("AUTH:" & Longest & CR & LF, Right, Longest);
      Expect ("AUTH:" & Longest & CR & 'x', Wrong, Longest);
   end Test_Too_Long;

   procedure Test_Wrong is
   begin
      Expect ((1 => LF), Wrong);
      Expect (CR & LF, Wrong);
      Expect ("ROPN" & LF, Wrong);
      Expect ("AUTH" & LF, Wrong);
      Expect ("AUTH:" & LF, Wrong);
      Expect ("auth:" & Usual & LF, Wrong);
      Expect ("AUTH " & Usual & LF, Wrong);
      Expect ("AUTH: " & Usual & LF, Wrong);
      Expect (" AUTH:" & Usual & LF, Wrong);
      Expect ("AUTH:" & Usual & " " & LF, Wrong);
      Expect ("AUTH:" & Usual & CR & CR & LF, Wrong);
      Expect ("AUTH:" & Usual & ASCII.NUL & LF, Wrong);
      Expect ("AUTH:" & ASCII.NUL & Usual & LF, Wrong);
      Expect ("AUTH:" & Usual & Usual & LF, Wrong);
      Expect (Usual & LF, Wrong);
   end Test_Wrong;

   procedure Add_Tests is
   begin
      Add_Test ("the file of a token", Test_Files'Access);
      Add_Test ("who may read it", Test_Modes'Access);
      Add_Test ("the right line", Test_Right'Access);
      Add_Test ("wrong lines", Test_Wrong'Access);
      Add_Test ("a difference at every place", Test_Every_Place'Access);
      Add_Test ("a line without end", Test_Too_Long'Access);
      Add_Test ("what the log shows", Test_Shown'Access);
   end Add_Tests;

end Authentication_Tests;
