--  SPDX-License-Identifier: GPL-3.0-or-later

package body Networks with SPARK_Mode is

   procedure Parse (Text : String; N : out Network; Good : out Boolean) is
      Start  : Address := 0;
      Octets : Natural range 0 .. 4 := 0;  --  in Start
      Number : Natural range 0 .. 255 := 0;
      Digit  : Boolean := False;  --  Number has one at least
   begin
      N := (others => <>);
      Good := False;
      for C of Text loop
         pragma Loop_Invariant (if not Digit then Number = 0);
         if C in '0' .. '9'
           and then (not Digit or else Number in 1 .. 24
                     or else (Number = 25 and then C <= '5'))
         then
            Number := 10 * Number + (Character'Pos (C) - Character'Pos ('0'));
            Digit := True;
         elsif Digit and then Octets < 4
           and then C = (if Octets = 3 then '/' else '.')
         then
            Start := 256 * Start + Address (Number);
            Octets := Octets + 1;
            Number := 0;
            Digit := False;
         else
            return;
         end if;
      end loop;
      if Digit
        and then (Octets = 3 or else (Octets = 4 and then Number <= 32))
      then
         N := (if Octets = 3 then (256 * Start + Address (Number), 32)
               else (Start, Number));
         Good := Is_Network (N);
      end if;
   end Parse;

end Networks;
