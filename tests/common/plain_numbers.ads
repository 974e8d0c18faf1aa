--  SPDX-License-Identifier: GPL-3.0-or-later
--  Numbers without a leading blank.

package Plain_Numbers is

   function Image (Value : Integer) return String;

   function Rounded (Value : Float; Aft : Natural := 2) return String;
   --  With Aft decimals; without a point if Aft is 0

end Plain_Numbers;
