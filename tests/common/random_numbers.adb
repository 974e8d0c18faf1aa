--  SPDX-License-Identifier: GPL-3.0-or-later
--  Random numbers that a seed repeats.

with Interfaces; use Interfaces;

package body Random_Numbers is

   procedure Step (Source : in out Generator; Value : out Unsigned_64) is
      --  A counter with an odd step, its bits mixed
   begin
      Source.State := Source.State + 16#9E37_79B9_7F4A_7C15#;
      Value := Source.State;
      Value := (Value xor Shift_Right (Value, 30)) * 16#BF58_476D_1CE4_E5B9#;
      Value := (Value xor Shift_Right (Value, 27)) * 16#94D0_49BB_1331_11EB#;
      Value := Value xor Shift_Right (Value, 31);
   end Step;

   procedure Start
     (Source : in out Generator; Seed : Natural; Name : String)
   is
      Value : Unsigned_64;
   begin
      Source.State := Unsigned_64 (Seed);
      for C of Name loop
         Step (Source, Value);
         Source.State := Value xor Unsigned_64 (Character'Pos (C));
      end loop;
   end Start;

   function Whole
     (Source : in out Generator; Low, High : Integer) return Integer
   is
      Value : Unsigned_64;
   begin
      Step (Source, Value);
      return Integer
        (Long_Long_Integer (Low)
         + Long_Long_Integer
             (Shift_Right (Value, 1)
              mod Unsigned_64
                (Long_Long_Integer (High) - Long_Long_Integer (Low) + 1)));
   end Whole;

end Random_Numbers;
