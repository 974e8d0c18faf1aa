--  SPDX-License-Identifier: GPL-3.0-or-later
--  The points of a mission: coordinates, their number, and what is no path.

with Ada.Numerics.Discrete_Random;
with Ada.Strings.Fixed;

with AUnit.Assertions; use AUnit.Assertions;

with Missions.Paths;   use Missions;
with Unit_Runs; use Unit_Runs;

package body Missions_Paths_Tests is

   function Parsed (Text : String; Single : Boolean := False) return Path is
      --  Of centimetres. Count 0: no path
      P     : Path;
      Valid : Boolean;
   begin
      Paths.Parse (Text, Text'First, Centimetres, Single, P, Valid);
      Assert (Valid = (P.Count > 0), Text & ": valid or empty");
      Assert (P.Measure = Centimetres, "the unit");
      return P;
   end Parsed;

   procedure Check (Text : String; Value : Millionths) is
      --  A coordinate, first and second
      P : constant Path := Parsed (Text & ";5;7;" & Text);
   begin
      Assert (P.Count = 2, Text & " is a coordinate");
      Assert (P.Points (1) = (Value, 5_000_000), Text & " first");
      Assert (P.Points (2) = (7_000_000, Value), Text & " last");
   end Check;

   procedure Check_None (Text : String) is
      --  No coordinate, first or second
   begin
      Assert (Parsed (Text & ";1").Count = 0, Text & " first");
      Assert (Parsed ("1;" & Text).Count = 0, Text & " last");
      Assert (Parsed ("1;2;" & Text & ";4").Count = 0, Text & " third");
   end Check_None;

   procedure Test_Counts is
      Text : String (1 .. 4 * 66) := (others => ';');
   begin
      for I in 0 .. 65 loop
         Text (4 * I + 1) := Character'Val (48 + I mod 10);
         Text (4 * I + 3) := Character'Val (48 + I / 10);
      end loop;
      for Count in 1 .. 66 loop
         declare
            P : constant Path := Parsed (Text (1 .. 4 * Count - 1));
            S : constant Path := Parsed (Text (1 .. 4 * Count - 1), True);
         begin
            Assert (P.Count = (if Count <= 64 then Count else 0), "any");
            Assert (S.Count = (if Count = 1 then 1 else 0), "single");
            for I in 1 .. P.Count loop
               Assert
                 (P.Points (I) =
                    (Millionths ((I - 1) mod 10) * 1_000_000,
                     Millionths ((I - 1) / 10) * 1_000_000),
                  "point" & I'Image);
            end loop;
         end;
      end loop;
   end Test_Counts;

   procedure Test_No_Values is
   begin
      Check_None ("");
      Check_None ("-");
      Check_None (".");
      Check_None ("-.");
      Check_None ("+1");
      Check_None ("--1");
      Check_None ("1.");
      Check_None (".5");
      Check_None ("-.5");
      Check_None ("12345678");
      Check_None ("00000001");
      Check_None ("1.1234567");
      Check_None ("1.2.3");
      Check_None ("1,5");
      Check_None ("1e3");
      Check_None ("0x10");
      Check_None (" 1");
      Check_None ("1 ");
      Check_None ("1-");
      Check_None ("nan");
      for C in Character loop
         if C not in '0' .. '9' then
            Check_None ((1 => C));
            if C /= ';' then
               Check_None ("1" & C);
               Check_None ("1.2" & C);
               Check_None ("1" & C & "2" & C & "3");
            end if;
         end if;
      end loop;
   end Test_No_Values;

   procedure Test_Places is
      High  : constant String (Integer'Last - 9 .. Integer'Last - 1) :=
        "MGCM:12;3";
      P     : Path;
      Valid : Boolean;
   begin
      Paths.Parse (High, High'First + 5, Pixels, True, P, Valid);
      Assert (Valid and then P.Count = 1 and then P.Measure = Pixels
              and then P.Points (1) = (12_000_000, 3_000_000), "high");
      Paths.Parse (High, High'Last + 1, Pixels, True, P, Valid);
      Assert (not Valid and then P.Count = 0, "nothing");
      Paths.Parse (High, High'First, Pixels, True, P, Valid);
      Assert (not Valid, "the label, too");
   end Test_Places;

   procedure Test_Points is
   begin
      Assert (Parsed ("1;2").Count = 1, "a point");
      Assert (Parsed ("").Count = 0, "empty");
      Assert (Parsed (";").Count = 0, "a separator");
      Assert (Parsed ("1").Count = 0, "one coordinate");
      Assert (Parsed ("1;").Count = 0, "half a point");
      Assert (Parsed (";1").Count = 0, "the other half");
      Assert (Parsed ("1;2;").Count = 0, "a separator at the end");
      Assert (Parsed (";1;2").Count = 0, "a separator at the beginning");
      Assert (Parsed ("1;2;3").Count = 0, "one and a half");
      Assert (Parsed ("1;;2").Count = 0, "an empty coordinate");
      Assert (Parsed ("1;2;3;").Count = 0, "one and nearly two");
      Assert (Parsed ("1;2;3;4").Count = 2, "two");
      Assert (Parsed ("1:2").Count = 0, "another separator");
   end Test_Points;

   procedure Test_Random is

      subtype Small is Integer range -9_999_999 .. 9_999_999;

      package Random_Parts is new Ada.Numerics.Discrete_Random (Small);

      G : Random_Parts.Generator;

      function Trimmed (Value : Integer) return String is
        (Ada.Strings.Fixed.Trim (Value'Image, Ada.Strings.Left));

   begin
      Random_Parts.Reset (G, 11);
      for Round in 1 .. 20_000 loop
         declare
            Whole  : constant Small :=
              Random_Parts.Random (G) / 10 ** (Round mod 8);
            Places : constant Positive := 1 + Round mod 6;
            Part   : constant Natural :=
              abs Random_Parts.Random (G) mod 10 ** Places;
            Value  : constant Millionths :=
              Millionths (abs Whole) * 1_000_000
              + Millionths (Part) * Millionths (10 ** (6 - Places));
         begin
            Check
              (Trimmed (Whole) & "."
               & Ada.Strings.Fixed.Tail (Trimmed (Part), Places, '0'),
               (if Whole < 0 then -Value else Value));
            Check (Trimmed (Whole), Millionths (Whole) * 1_000_000);
         end;
      end loop;
   end Test_Random;

   procedure Test_Values is
   begin
      Check ("0", 0);
      Check ("-0", 0);
      Check ("7", 7_000_000);
      Check ("-7", -7_000_000);
      Check ("007", 7_000_000);
      Check ("0000001", 1_000_000);
      Check ("9999999", 9_999_999_000_000);
      Check ("9999999.999999", 9_999_999_999_999);
      Check ("-9999999.999999", -9_999_999_999_999);
      Check ("0.1", 100_000);
      Check ("0.12", 120_000);
      Check ("0.123", 123_000);
      Check ("0.1234", 123_400);
      Check ("0.12345", 123_450);
      Check ("0.123456", 123_456);
      Check ("-0.000001", -1);
      Check ("-12.50", -12_500_000);
      Check ("320.5", 320_500_000);
   end Test_Values;

   procedure Add_Tests is
   begin
      Add_Test ("coordinates", Test_Values'Access);
      Add_Test ("no coordinates", Test_No_Values'Access);
      Add_Test ("pairs and separators", Test_Points'Access);
      Add_Test ("1 to 64 points, or one", Test_Counts'Access);
      Add_Test ("paths in a line", Test_Places'Access);
      Add_Test ("random paths", Test_Random'Access);
   end Add_Tests;

end Missions_Paths_Tests;
