--  SPDX-License-Identifier: GPL-3.0-or-later

package body Admission.Networks with SPARK_Mode is

   procedure Parse (Text : String; N : out Network; Good : out Boolean) is
      Numbers : array (1 .. 5) of Natural := (5 => 32, others => 0);
      --  the octets of the address, and the length
      Place   : Positive range 1 .. 5 := 1;
      Digit   : Boolean := False;
      --  Text begins with numbers before Place, and one more if it is True
   begin
      N := (others => <>);
      Good := False;
      for C of Text loop
         pragma Loop_Invariant
           (for all I in 1 .. 4 => Numbers (I) <= 255);
         pragma Loop_Invariant (Numbers (5) <= 32);
         if C in '0' .. '9' then
            if Digit and then Numbers (Place) = 0 then
               return;
            end if;
            Numbers (Place) := (if Digit then 10 * Numbers (Place) else 0)
              + (Character'Pos (C) - Character'Pos ('0'));
            Digit := True;
            if Numbers (Place) > (if Place = 5 then 32 else 255) then
               return;
            end if;
         elsif Digit and then Place < 5
           and then C = (if Place = 4 then '/' else '.')
         then
            Place := Place + 1;
            Digit := False;
         else
            return;
         end if;
      end loop;
      N := (Joined (Bytes.Byte (Numbers (1)), Bytes.Byte (Numbers (2)),
                    Bytes.Byte (Numbers (3)), Bytes.Byte (Numbers (4))),
            Numbers (5));
      Good := Digit and then Place >= 4 and then Is_Network (N);
   end Parse;

end Admission.Networks;
