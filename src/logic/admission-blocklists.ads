--  SPDX-License-Identifier: GPL-3.0-or-later
--  Sources that connect faster than th_server can handle are blocked for a
--  while: they are found in the history of the last connections.

with Admission.Networks;

package Admission.Blocklists with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Admission.Blocklists);

   use type Admission.Networks.Source;

   --  Arrivals

   Max_Arrivals : constant := 64;

   subtype Arrival_Count is Natural range 0 .. Max_Arrivals;

   subtype Arrival_Place is Positive range 1 .. Max_Arrivals;

   type History is private;
   --  The sources of the last connections. Initially none

   procedure Note (H : in out History; S : Admission.Networks.Source)
   with Post => Count_Of (H, S) > 0;
   --  Records a connection from S

   procedure Clear (H : out History);

   function Count_Of
     (H : History; S : Admission.Networks.Source) return Arrival_Count;
   --  Number of connections from S in the history

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
   --  So many of the last connections are a flood if the server cannot keep
   --  up. A monitor that retries now and then has fewer

   procedure Extend (L : in out List; H : History; Grown : out Boolean)
   with
     Post => L.Count >= L.Count'Old
       and then Grown = (L.Count > L.Count'Old)
       and then (for all I in 1 .. L.Count'Old =>
                   L.Items (I) = L.Items'Old (I))
       and then (for all I in L.Count'Old + 1 .. L.Count =>
                   Count_Of (H, L.Items (I)) >= Threshold);
   --  Adds the sources that flood, while the list has room

   procedure Remove_Oldest (L : in out List)
   with
     Pre  => L.Count > 0,
     Post => L.Count = L.Count'Old - 1
       and then (for all I in 1 .. L.Count =>
                   L.Items (I) = L.Items'Old (I + 1));

private

   type Arrival_Array is array (Arrival_Place) of Admission.Networks.Source;

   type History is record
      Items : Arrival_Array := (others => 0);
      Count : Arrival_Count := 0;
      Last  : Arrival_Place := Max_Arrivals;
   end record;
   --  A ring buffer: the first Count items are valid, the newest is at Last

end Admission.Blocklists;
