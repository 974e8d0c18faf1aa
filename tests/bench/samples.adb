--  SPDX-License-Identifier: GPL-3.0-or-later
--  Measured times of one kind, and their figures.

with Ada.Strings;       use Ada.Strings;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Ada.Text_IO;       use Ada.Text_IO;

package body Samples is

   Name_Width   : constant := 44;
   Column_Width : constant := 9;

   function Column (Text : String) return String is
     (Tail (Text, Column_Width));

   function Milliseconds (Value : Duration) return String;
   --  With three decimals

   ------------------
   -- Milliseconds --
   ------------------

   function Milliseconds (Value : Duration) return String is
      type Shown is delta 0.001 digits 12;
   begin
      return Trim (Shown'Image (Shown (Value * 1000)), Both);
   end Milliseconds;

   ---------
   -- Add --
   ---------

   procedure Add (Object : in out Set; Value : Duration) is
   begin
      Object.Values.Append (Value);
   end Add;

   -----------
   -- Count --
   -----------

   function Count (Object : Set) return Natural is
     (Natural (Object.Values.Length));

   ----------
   -- Mean --
   ----------

   function Mean (Object : Set) return Duration is
      Sum : Duration := 0.0;
   begin
      for Value of Object.Values loop
         Sum := Sum + Value;
      end loop;
      return (if Object.Values.Is_Empty then 0.0 else Sum / Object.Count);
   end Mean;

   --------------
   -- Quantile --
   --------------

   function Quantile (Object : Set; Share : Float) return Duration is
      Sorted : Vectors.Vector := Object.Values;
      Place  : Natural;
   begin
      if Sorted.Is_Empty then
         return 0.0;
      end if;
      Sorting.Sort (Sorted);
      Place := Natural (Float'Ceiling (Share * Float (Object.Count)));
      return Sorted (Integer'Max (1, Integer'Min (Place, Object.Count)));
   end Quantile;

   ------------------
   -- Print_Header --
   ------------------

   procedure Print_Header is
   begin
      Put_Line
        (Head ("times in ms", Name_Width) & Column ("samples")
         & Column ("median") & Column ("p99") & Column ("p99.9")
         & Column ("max") & "  demanded");
   end Print_Header;

   -----------
   -- Print --
   -----------

   procedure Print
     (Object : Set; Name : String; Demand : String; Met : Boolean) is
   begin
      Put_Line
        (Head (Name, Name_Width)
         & Column (Trim (Natural'Image (Object.Count), Both))
         & Column (Milliseconds (Object.Quantile (0.5)))
         & Column (Milliseconds (Object.Quantile (0.99)))
         & Column (Milliseconds (Object.Quantile (0.999)))
         & Column (Milliseconds (Object.Quantile (1.0)))
         & "  " & Demand
         & (if Demand = "" then "" elsif Met then ": met"
            else ": NOT MET"));
   end Print;

end Samples;
