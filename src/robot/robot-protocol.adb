--  SPDX-License-Identifier: GPL-3.0-or-later

package body Robot.Protocol with SPARK_Mode is

   procedure Prove_Same_Parity (A, B : Byte_Array; Last : Natural)
   with
     Ghost,
     Pre  => A'First = 1
       and then B'First = 1
       and then Last <= Natural'Min (A'Last, B'Last)
       and then Last <= Max_Frame
       and then (for all I in 1 .. Last => A (I) = B (I)),
     Post => Parity (A, Last) = Parity (B, Last)
   is
      --  A checksum depends only on its own text.
   begin
      for I in 1 .. Last loop
         pragma Loop_Invariant (Parity (A, I) = Parity (B, I));
      end loop;
   end Prove_Same_Parity;

   procedure Encode (C : Command; F : out Frame) is
      Last   : Frame_Length := 1;
      Before : Byte_Array (1 .. Frame_Length'Last) with Ghost;
   begin
      F := (Data => (others => 0), Length => 0);
      F.Data (1) := Character'Pos (Letter (C.Kind));
      if C.Kind in With_Argument then
         F.Data (2) := Character'Pos ('=');
         Last := 2;
         if C.Value < 0 then
            F.Data (3) := Character'Pos ('-');
            Last := 3;
         end if;
         Byte_Decimals.Append (abs C.Value, 1, F.Data, Last);
      end if;

      Before := F.Data;
      F.Data (Last + 1) := Checksum (F.Data, Last);
      F.Data (Last + 2) := Terminator;
      F.Length := Last + 2;
      Prove_Same_Parity (Before, F.Data, Last);
      if C.Kind in With_Argument then
         Byte_Decimals.Prove_Same_Value
           (Before, F.Data, (if C.Value < 0 then 4 else 3), Last);
      end if;
   end Encode;

   procedure Append (F : in out Frame; B : Byte) is
   begin
      if F.Length <= Max_Frame then
         F.Length := F.Length + 1;
         F.Data (F.Length) := B;
      end if;
   end Append;

   function Text_Of (F : Frame) return Commands.Answer_Text is
      Result : Commands.Answer_Text :=
        (Length => Text_Length (F), others => <>);
   begin
      for I in 1 .. Result.Length loop
         Result.Data (I) := Character'Val (F.Data (I));
      end loop;
      return Result;
   end Text_Of;

end Robot.Protocol;
