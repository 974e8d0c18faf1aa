--  SPDX-License-Identifier: GPL-3.0-or-later
--  Texts of bounded length, to be passed between tasks: no allocation, no
--  secondary stack.

package Texts with SPARK_Mode, Pure is

   Max_Length : constant := 512;

   type Text is record
      Data   : String (1 .. Max_Length) := (others => ' ');
      Length : Natural range 0 .. Max_Length := 0;
   end record;

   function Image (T : Text) return String is (T.Data (1 .. T.Length));

   procedure Set (T : out Text; Value : String)
   with
     Post => T.Length = Natural'Min (Value'Length, Max_Length)
       and then (for all I in 1 .. T.Length =>
                   T.Data (I) = Value (Value'First + (I - 1)));
   --  Value, truncated to Max_Length

   procedure Append (T : in out Text; Value : String)
   with
     Post => T.Length - T'Old.Length =
         Natural'Min (Value'Length, Max_Length - T'Old.Length)
       and then (for all I in 1 .. T'Old.Length =>
                   T.Data (I) = T'Old.Data (I))
       and then (for all I in T'Old.Length + 1 .. T.Length =>
                   T.Data (I) =
                     Value (Value'First + (I - T'Old.Length - 1)));
   --  T followed by Value, truncated to Max_Length

   procedure Append
     (T : in out Text; Value : Integer; Width : Positive := 1)
   with
     Pre  => Width <= 10,
     Post => T.Length >= T'Old.Length
       and then T.Length - T'Old.Length <= 11
       and then (for all I in 1 .. T'Old.Length =>
                   T.Data (I) = T'Old.Data (I));
   --  T followed by Value in decimal, with a minus sign if negative, and zeros
   --  before it up to Width digits

   function To_Text (Value : String) return Text
   with
     Post => To_Text'Result.Length = Natural'Min (Value'Length, Max_Length)
       and then (for all I in 1 .. To_Text'Result.Length =>
                   To_Text'Result.Data (I) = Value (Value'First + (I - 1)));
   --  Value, truncated to Max_Length

end Texts;
