--  SPDX-License-Identifier: GPL-3.0-or-later

package body Base64 with SPARK_Mode is

   pragma Assertion_Policy (Loop_Invariant => Ignore);
   --  They examine all that is written so far: proved, but at run time the
   --  work would be quadratic

   procedure Encode
     (Input  : Byte_Array;
      Length : Input_Length;
      Output : in out String;
      First  : Positive;
      Last   : out Natural)
   is
      pragma Suppress (All_Checks);
      --  every image passes here: the run-time checks, all proved, would cost
      --  time for each byte
   begin
      Last := First - 1;
      for K in 0 .. Encoded_Length (Length) / 4 - 1 loop
         Output (Last + 1) := Encoded_At (Input, Length, K, 0);
         Output (Last + 2) := Encoded_At (Input, Length, K, 1);
         Output (Last + 3) := Encoded_At (Input, Length, K, 2);
         Output (Last + 4) := Encoded_At (Input, Length, K, 3);
         Last := Last + 4;
         pragma Loop_Invariant (Last = First + 4 * K + 3);
         pragma Loop_Invariant
           (for all G in 0 .. K =>
              (for all J in 0 .. 3 =>
                 Output (First + 4 * G + J)
                   = Encoded_At (Input, Length, G, J)));
      end loop;
   end Encode;

end Base64;
