--  SPDX-License-Identifier: GPL-3.0-or-later

package body Robot.Protocol.Proof with SPARK_Mode is

   procedure Prove_Reception (Data : Byte_Array; Pending : Command_Kind) is
      R        : Receiver;
      F        : Frame;
      Complete : Boolean;
      Answer   : Reply;
   begin
      for I in Data'Range loop
         Accept_Byte (R, Data (I), Complete);
         pragma Assert (not Complete);
         pragma Loop_Invariant (not R.Finished);
         pragma Loop_Invariant (R.Length = Natural'Min (I, Max_Frame));
         pragma Loop_Invariant (R.Overflow = (I > Max_Frame));
         pragma Loop_Invariant
           (for all J in 1 .. R.Length => R.Data (J) = Data (J));
      end loop;
      Accept_Byte (R, Terminator, Complete);
      pragma Assert (Complete);
      Get (R, F);
      pragma Assert
        (F.Length = (if Data'Length > Max_Frame then 0 else Data'Length));
      pragma Assert (for all I in 1 .. F.Length => F.Data (I) = Data (I));
      Decode (F, Pending, Answer);
      pragma Assert (if F.Length < 2 then Answer.Kind = Malformed);
      pragma Assert
        (Is_Answer (Answer.Kind, Pending)
         or else Answer.Kind in Refused | Unknown_Command
         or else Answer.Kind in Failed_Reply);
   end Prove_Reception;

end Robot.Protocol.Proof;
