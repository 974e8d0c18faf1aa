--  SPDX-License-Identifier: GPL-3.0-or-later
--  Texts of bounded length, for what crosses from one task to another: no
--  allocation, no secondary stack.

package Texts with SPARK_Mode, Pure is

   Max_Length : constant := 512;

   type Text is record
      Data   : String (1 .. Max_Length) := (others => ' ');
      Length : Natural range 0 .. Max_Length := 0;
   end record;

   function Image (T : Text) return String is (T.Data (1 .. T.Length));

   procedure Set (T : out Text; Value : String);
   --  Value, cut at Max_Length

   procedure Append (T : in out Text; Value : String);
   --  T followed by Value, cut at Max_Length

   procedure Append (T : in out Text; Value : Integer);
   --  T followed by Value in decimal, with a minus sign where negative

   function To_Text (Value : String) return Text;
   --  Value, cut at Max_Length

end Texts;
