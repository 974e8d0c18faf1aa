--  SPDX-License-Identifier: GPL-3.0-or-later
--  Bounded texts: cut at their length, numbers in decimal.

with Ada.Strings.Fixed;

with Plain_Numbers;
with Texts;            use Texts;
with Unit_Runs; use Unit_Runs;

procedure Texts_Tests is

   procedure Check_Number (N : Integer) is
      --  Against the language's own image.
      Item : Text;
   begin
      Append (Item, N);
      Assert (Image (Item) = Plain_Numbers.Image (N), "image of" & N'Image);
   end Check_Number;

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

   procedure Test_Width is
      Item : Text;
   begin
      Append (Item, 7, Width => 3);
      Append (Item, -42, Width => 10);
      Append (Item, 1_234, Width => 2);
      Assert (Image (Item) = "007-00000000421234", Image (Item));
   end Test_Width;

begin
   Run_Test ("numbers", Test_Numbers'Access);
   Run_Test ("zeros before a number", Test_Width'Access);
   Run_Test ("a number cut", Test_Cut_Number'Access);
end Texts_Tests;
