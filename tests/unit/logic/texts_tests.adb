--  SPDX-License-Identifier: GPL-3.0-or-later
--  Bounded texts: cut at their length, numbers in decimal.

with Ada.Strings.Fixed;

with AUnit.Assertions; use AUnit.Assertions;

with Texts;            use Texts;
with Unit_Runs; use Unit_Runs;

package body Texts_Tests is

   function Trimmed (N : Integer) return String is
     (Ada.Strings.Fixed.Trim (Integer'Image (N), Ada.Strings.Left));

   procedure Check_Number (N : Integer) is
      --  Against the language's own image.
      Item : Text;
   begin
      Append (Item, N);
      Assert (Image (Item) = Trimmed (N), "image of" & N'Image);
   end Check_Number;

   procedure Test_Append is
      Item : Text;
   begin
      Assert (Image (Item) = "", "empty at first");
      Append (Item, "");
      Assert (Item = Text'(others => <>), "nothing appended");
      Append (Item, "battery ");
      Append (Item, 2);
      Append (Item, ", ");
      Append (Item, -15);
      Append (Item, "!");
      Assert (Image (Item) = "battery 2, -15!", "all in order");
   end Test_Append;

   procedure Test_Cut is
      Item : Text;
      Long : String (1 .. Max_Length + 88);
   begin
      for I in Long'Range loop
         Long (I) := Character'Val (32 + I mod 90);
      end loop;
      for Length in Max_Length - 1 .. Long'Last loop
         declare
            Kept : constant String :=
              Long (1 .. Integer'Min (Length, Max_Length));
         begin
            Set (Item, Long (1 .. Length));
            Assert (Image (Item) = Kept, "set, length" & Length'Image);
            Assert (Image (To_Text (Long (1 .. Length))) = Kept,
                    "to text, length" & Length'Image);
            Set (Item, Long (1 .. 100));
            Append (Item, Long (101 .. Length));
            Assert (Image (Item) = Kept, "append, length" & Length'Image);
         end;
      end loop;
      Append (Item, "more");
      Append (Item, 7);
      Assert (Image (Item) = Long (1 .. Max_Length), "full stays full");
   end Test_Cut;

   procedure Test_Cut_Number is
      Item : Text;
      Fill : constant String (1 .. Max_Length) := (others => '.');
   begin
      for Free in 0 .. 12 loop
         Set (Item, Fill (1 .. Max_Length - Free));
         Append (Item, -1_234_567_890);
         Assert (Image (Item) = Fill (1 .. Max_Length - Free)
                 & Ada.Strings.Fixed.Head
                     ("-1234567890", Integer'Min (Free, 11)),
                 "room for" & Free'Image);
      end loop;
   end Test_Cut_Number;

   procedure Test_Numbers is
   begin
      for N in -1_100 .. 1_100 loop
         Check_Number (N);
      end loop;
      for Digit in 0 .. 9 loop
         for Beside in -1 .. 1 loop
            Check_Number (10 ** Digit + Beside);
            Check_Number (-(10 ** Digit + Beside));
         end loop;
      end loop;
      Check_Number (Integer'Last);
      Check_Number (Integer'First);
      Check_Number (Integer'First + 1);
   end Test_Numbers;

   procedure Test_Set is
      Item   : Text;
      Inside : constant String := "[arena]";
   begin
      Set (Item, "a longer one");
      Assert (Image (Item) = "a longer one", "set");
      Set (Item, Inside (2 .. 6));
      Assert (Image (Item) = "arena", "what was there is gone");
      Assert (Item = To_Text ("arena"), "blank behind the text");
      Assert (Image (To_Text (Inside (2 .. 6))) = "arena",
              "any first index");
      Set (Item, "");
      Assert (Item = To_Text (""), "empty");
   end Test_Set;

   procedure Add_Tests is
   begin
      Add_Test ("set", Test_Set'Access);
      Add_Test ("append", Test_Append'Access);
      Add_Test ("numbers", Test_Numbers'Access);
      Add_Test ("cut at the end", Test_Cut'Access);
      Add_Test ("a number cut", Test_Cut_Number'Access);
   end Add_Tests;

end Texts_Tests;
