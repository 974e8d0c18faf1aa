--  SPDX-License-Identifier: GPL-3.0-or-later
--  Numbers as people write them.

with Ada.Long_Float_Text_IO;
with Ada.Strings.Fixed;

package body Numerals is

   function Are_Digits (Text : String) return Boolean is
     (Text'Length in 1 .. 9 and then (for all C of Text => C in '0' .. '9'));
   --  Nine digits fit in every Integer

   function Image (Value : Integer) return String is
     (Ada.Strings.Fixed.Trim (Integer'Image (Value), Ada.Strings.Left));

   function Image (Value : Long_Float; Decimals : Natural) return String is
      Field : String (1 .. 40);
   begin
      Ada.Long_Float_Text_IO.Put (Field, Value, Aft => Decimals, Exp => 0);
      return Ada.Strings.Fixed.Trim (Field, Ada.Strings.Left);
   end Image;

   function Seconds (Span : Duration) return String is
     (Image (Long_Float (Span), 3));

   function Milliseconds (Span : Duration; Decimals : Natural := 2)
     return String
   is (Image (Long_Float (Span) * 1_000.0, Decimals));

   procedure Read (Text : String; Value : out Duration; OK : out Boolean) is
      Point : constant Natural := Ada.Strings.Fixed.Index (Text, ".");
      Whole : constant String :=
        (if Point = 0 then Text else Text (Text'First .. Point - 1));
      Part  : constant String :=
        (if Point = 0 then "0" else Text (Point + 1 .. Text'Last));
   begin
      OK := Are_Digits (Whole)
        and then Are_Digits (Part)
        and then Integer'Value (Whole) < 86_400;
      Value :=
        (if OK
         then Duration (Integer'Value (Whole))
           + Duration (Long_Float'Value (Part) / 10.0 ** Part'Length)
         else 0.0);
   end Read;

   procedure Read
     (Text  : String;
      First : Integer;
      Last  : Integer;
      Value : out Integer;
      OK    : out Boolean)
   is
      Negative : constant Boolean :=
        Text'Length > 0 and then Text (Text'First) = '-';
      Absolute : constant String :=
        Text (Text'First + Boolean'Pos (Negative) .. Text'Last);
   begin
      OK := Are_Digits (Absolute);
      Value := (if OK then Integer'Value (Absolute) else 0);
      if Negative then
         Value := -Value;
      end if;
      OK := OK and then Value in First .. Last;
   end Read;

end Numerals;
