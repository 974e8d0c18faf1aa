--  SPDX-License-Identifier: GPL-3.0-or-later
--  The points of a mission: coordinates, their number, and what is no path.

with AUnit.Assertions; use AUnit.Assertions;

with Missions;  use Missions;
with Monitor.Protocol;
with Unit_Runs; use Unit_Runs;

procedure Monitor_Paths_Tests is

   function Parsed (Text : String) return Path is
      --  Of centimetres. Count 0: no path
      P     : Path;
      Valid : Boolean;
   begin
      Monitor.Protocol.Parse
        (Text, Text'First, Centimetres, Max_Points, P, Valid);
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

   procedure Test_No_Values is
   begin
      for Text of Split
        ("|-|.|-.|+1|--1|1.|.5|-.5|12345678|00000001|1.1234567|1.2.3|1,5"
         & "|1e3|0x10| 1|1 |1-|nan")
      loop
         Check_None (Text);
      end loop;
   end Test_No_Values;

   procedure Test_Points is
   begin
      Assert (Parsed ("1;2").Count = 1, "a point");
      Assert (Parsed ("1;2;3;4").Count = 2, "two");
      for Text of Split ("|;|1|1;|;1|1;2;|;1;2|1;2;3|1;;2|1;2;3;|1:2") loop
         Assert (Parsed (Text).Count = 0, Text);
      end loop;
   end Test_Points;

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

begin
   Run_Test ("coordinates", Test_Values'Access);
   Run_Test ("no coordinates", Test_No_Values'Access);
   Run_Test ("pairs and separators", Test_Points'Access);
end Monitor_Paths_Tests;
