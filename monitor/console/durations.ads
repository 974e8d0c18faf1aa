--  SPDX-License-Identifier: GPL-3.0-or-later
--  Measured durations, with their statistics: mean, quantiles, longest.

package Durations is

   Capacity : constant := 100_000;
   --  Only the newest are kept: about three hours of images

   type Set is limited private;

   procedure Add (To : in out Set; Value : Duration);

   function Count (Of_Set : Set) return Natural;
   --  Number kept

   function Mean (Of_Set : Set) return Duration
   with Pre => Count (Of_Set) > 0;

   function Quantile (Of_Set : Set; Share : Long_Float) return Duration
   with Pre => Count (Of_Set) > 0 and then Share in 0.0 .. 1.0;
   --  The smallest value that is not exceeded by at least this share of the
   --  values: 0.5 gives the median, 1.0 the longest.

private

   type Values is array (Positive range <>) of Duration;

   type Set is limited record
      Data  : Values (1 .. Capacity);
      Count : Natural  := 0;
      Next  : Positive := 1;
   end record;

   function Count (Of_Set : Set) return Natural is (Of_Set.Count);

end Durations;
