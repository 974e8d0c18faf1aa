--  SPDX-License-Identifier: GPL-3.0-or-later

package body Robot.Protocol.Proof with SPARK_Mode is

   procedure Prove_Reception (Data : Byte_Array; Pending : Command_Kind) is
      F      : Frame;
      Answer : Reply;
   begin
      for I in Data'Range loop
         Append (F, Data (I));
         pragma Loop_Invariant (F.Length = Natural'Min (I, Max_Frame + 1));
         pragma Loop_Invariant
           (for all J in 1 .. F.Length => F.Data (J) = Data (J));
      end loop;
      Answer := Decode (F, Pending);
      pragma Assert
        (if Data'Length not in 2 .. Max_Frame
         then Answer.Kind = Malformed);
      pragma Assert
        (Is_Answer (Answer.Kind, Pending)
         or else Answer.Kind in Refused | Unknown_Command
         or else Answer.Kind in Failed_Reply);
   end Prove_Reception;

end Robot.Protocol.Proof;
