--  SPDX-License-Identifier: GPL-3.0-or-later
--  Numbers as one writes them.

with Ada.Float_Text_IO;
with Ada.Strings;       use Ada.Strings;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;

package body Plain_Numbers is

   function Image (Value : Integer) return String is
     (Trim (Value'Image, Left));

   function Rounded (Value : Float; Aft : Natural := 2) return String is
      Text : String (1 .. 48);
      Last : Natural := Text'Last;
   begin
      Ada.Float_Text_IO.Put (Text, Value, Aft => Aft, Exp => 0);
      if Aft = 0 then
         --  Put writes one decimal all the same
         Last := Index (Text, ".") - 1;
      end if;
      return Trim (Text (1 .. Last), Left);
   end Rounded;

end Plain_Numbers;
