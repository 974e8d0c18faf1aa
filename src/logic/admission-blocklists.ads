--  SPDX-License-Identifier: GPL-3.0-or-later
--  Sources that connect faster than they can be seen to, and are blocked for
--  a while: found among those that have connected last.

with Admission.Networks;

package Admission.Blocklists with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Admission.Blocklists);
   --  A claim that GNATprove checks: every subprogram ends

   use type Admission.Networks.Source;

   --  Arrivals

   Max_Arrivals : constant := 64;

   subtype Arrival_Count is Natural range 0 .. Max_Arrivals;

   subtype Arrival_Place is Positive range 1 .. Max_Arrivals;

   type History is private;
   --  The sources of the last connections. Initially none

   procedure Note (H : in out History; S : Admission.Networks.Source)
   with Post => Count_Of (H, S) > 0;
   --  One has come from there

   procedure Clear (H : out History);

   function Count_Of
     (H : History; S : Admission.Networks.Source) return Arrival_Count;
   --  How many have come from there

   --  Lists

   Max_Sources : constant := 16;

   subtype Source_Count is Natural range 0 .. Max_Sources;

   type Source_Array is array (1 .. Max_Sources) of Admission.Networks.Source;

   type List is record
      Items : Source_Array := (others => 0);
      Count : Source_Count := 0;
   end record;
   --  The first Count items count. Initially there is none

   function Contains
     (L : List; S : Admission.Networks.Source) return Boolean is
     (for some I in 1 .. L.Count => L.Items (I) = S);

   Threshold : constant := Max_Arrivals / Max_Sources;
   --  So many of the last arrivals are a flood where more come than can be
   --  seen to. A monitor that tries again now and then has fewer

   procedure Extend (L : in out List; H : History; Grown : out Boolean)
   with
     Post => L.Count >= L.Count'Old
       and then Grown = (L.Count > L.Count'Old)
       and then (for all I in 1 .. L.Count'Old =>
                   L.Items (I) = L.Items'Old (I))
       and then (for all I in L.Count'Old + 1 .. L.Count =>
                   Count_Of (H, L.Items (I)) >= Threshold);
   --  By the sources that flood, while there is room

private

   type Arrival_Array is array (Arrival_Place) of Admission.Networks.Source;

   type History is record
      Items : Arrival_Array := (others => 0);
      Count : Arrival_Count := 0;
      Last  : Arrival_Place := Max_Arrivals;
   end record;
   --  A ring: the first Count items count, the newest is at Last

end Admission.Blocklists;
