--  SPDX-License-Identifier: GPL-3.0-or-later
--  Decimal numbers: every count of digits, saturation, leading zeros.

with Ada.Strings.Fixed;

with AUnit.Assertions; use AUnit.Assertions;

with Bytes;            use Bytes;
with Decimals;
with Unit_Runs; use Unit_Runs;

package body Decimals_Tests is

   package Texts is new Decimals (Character, String);

   package Octets is new Decimals (Byte, Byte_Array);

   function Image (N : Natural) return String is
     (Ada.Strings.Fixed.Trim (Natural'Image (N), Ada.Strings.Both));

   function Padded (N : Natural; Width : Positive) return String is
     (if Image (N)'Length >= Width then Image (N)
      else Ada.Strings.Fixed.Tail (Image (N), Width, '0'));

   procedure Check_Append (N : Texts.Number; Width : Texts.Digit_Count) is
      --  Against the language's own image.
      Text : String (1 .. 12) := (others => '.');
      Last : Natural := 2;
   begin
      Texts.Append (N, Width, Text, Last);
      Assert (Text (3 .. Last) = Padded (N, Width), "digits of" & N'Image);
      Assert (Text (1 .. 2) = ".."
              and then (for all I in Last + 1 .. 12 => Text (I) = '.'),
              "around" & N'Image);
      Assert (Texts.Value (Text, 3, Last) = N, "value of" & N'Image);
      Assert (Texts.Saturated_Value (Text, 3, Last) = N,
              "saturated value of" & N'Image);
   end Check_Append;

   procedure Test_Append is
   begin
      for N in 0 .. 100_000 loop
         Check_Append (N, 1);
      end loop;
   end Test_Append;

   procedure Test_Edges is
   begin
      for Width in Texts.Digit_Count loop
         for Count in Texts.Digit_Count loop
            Check_Append (10 ** (Count - 1), Width);
            Check_Append (Texts.Largest (Count), Width);
            Check_Append (Texts.Largest (Count) - 1, Width);
            Check_Append (Texts.Largest (Count) / 7, Width);
         end loop;
         Check_Append (0, Width);
      end loop;
   end Test_Edges;

   procedure Test_Octets is
      Data : Byte_Array (1 .. 20) := (others => 7);
      Last : Natural := 4;
   begin
      Octets.Append (90_210, 6, Data, Last);
      Assert (Last = 10
              and then Data (4 .. 11) = (7, 48, 57, 48, 50, 49, 48, 7),
              "octets are ASCII");
      for B in Byte loop
         Assert (Octets.Is_Digit (B)
                   = (Character'Val (B) in '0' .. '9'),
                 "digit" & B'Image);
      end loop;
   end Test_Octets;

   procedure Test_Saturated is

      procedure Check (Text : String; Expected : Texts.Number) is
         --  Text, in the midst of other characters.
         Line : constant String := "9x" & Text & "x9";
      begin
         Assert (Texts.Saturated_Value (Line, 3, Line'Last - 2) = Expected,
                 "value of " & Text);
      end Check;

      Zeros : constant String (1 .. 1000) := (others => '0');
      Nines : constant String (1 .. 1000) := (others => '9');
   begin
      Check ("0", 0);
      Check ("00000000", 0);
      Check ("000000000", 0);
      Check ("000000007", 7);
      Check ("99999999", 99_999_999);
      Check ("099999999", 99_999_999);
      Check ("100000000", 99_999_999);
      Check ("100000001", 99_999_999);
      Check (Zeros, 0);
      Check (Zeros & "42", 42);
      Check (Zeros & "32768", 32_768);
      Check ("1" & Zeros, 99_999_999);
      Check (Nines, 99_999_999);
      Check (Zeros & "1" & Zeros & "5", 99_999_999);
   end Test_Saturated;

   procedure Add_Tests is
   begin
      Add_Test ("0 to 100,000 and back", Test_Append'Access);
      Add_Test ("edges of every width", Test_Edges'Access);
      Add_Test ("octets", Test_Octets'Access);
      Add_Test ("any count of digits", Test_Saturated'Access);
   end Add_Tests;

end Decimals_Tests;
