--  SPDX-License-Identifier: GPL-3.0-or-later
--  Measured times of one kind, and their statistics.

with Ada.Containers.Vectors;

package Samples is

   type Set is tagged private;

   None : constant Set;

   procedure Add (Object : in out Set; Value : Duration);

   function Count (Object : Set) return Natural;

   function Element (Object : Set; Place : Positive) return Duration;
   --  The oldest is the first

   function Last (Object : Set) return Duration;
   --  The newest

   function Quantile (Object : Set; Share : Float) return Duration
     with Pre => Share in 0.0 .. 1.0;
   --  The smallest value that at least Share of the samples do not exceed; 0
   --  without samples

   function Usual_Worst (Object : Set; Run : Positive) return Duration;
   --  The median of the largest of each Run successive samples: what one
   --  disturbance does not change

private

   package Vectors is new Ada.Containers.Vectors (Positive, Duration);
   package Sorting is new Vectors.Generic_Sorting;

   type Set is tagged record
      Values : Vectors.Vector;
   end record;

   None : constant Set := (Values => Vectors.Empty_Vector);

end Samples;
