--  SPDX-License-Identifier: GPL-3.0-or-later
--  Measured times of one kind, and their figures.

with Ada.Containers.Vectors;

package Samples is

   type Set is tagged private;

   procedure Add (Object : in out Set; Value : Duration);

   function Count (Object : Set) return Natural;

   function Mean (Object : Set) return Duration;

   function Quantile (Object : Set; Share : Float) return Duration
     with Pre => Share in 0.0 .. 1.0;
   --  The smallest value that at least Share of the samples do not exceed;
   --  0 without samples

   procedure Print_Header;
   procedure Print
     (Object : Set; Name : String; Demand : String; Met : Boolean);
   --  One line of the table: count, median, p99, p99.9, maximum in ms

private

   package Vectors is new Ada.Containers.Vectors (Positive, Duration);
   package Sorting is new Vectors.Generic_Sorting;

   type Set is tagged record
      Values : Vectors.Vector;
   end record;

end Samples;
