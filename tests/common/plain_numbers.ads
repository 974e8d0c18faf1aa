--  SPDX-License-Identifier: GPL-3.0-or-later
--  Numbers as one writes them, without a blank in front.

package Plain_Numbers is

   function Image (Value : Integer) return String;

   function Rounded (Value : Float; Aft : Natural := 2) return String;
   --  With so many decimals, without a point where Aft is 0

end Plain_Numbers;
