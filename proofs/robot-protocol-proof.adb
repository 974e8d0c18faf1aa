--  SPDX-License-Identifier: GPL-3.0-or-later

package body Robot.Protocol.Proof with SPARK_Mode is

   procedure Prove_Reception (Data : Byte_Array; Pending : Command_Kind) is
      R        : Receiver;
      F        : Frame;
      Complete : Boolean;
      Answer   : Reply;
   begin
      for I in Data'Range loop
         Accept_Byte (R, Data (I), F, Complete);
         pragma Assert (not Complete);
         pragma Loop_Invariant (R.Length = Natural'Min (I, Max_Frame + 1));
         pragma Loop_Invariant
           (for all J in 1 .. Natural'Min (R.Length, Max_Frame) =>
              R.Data (J) = Data (J));
      end loop;
      Accept_Byte (R, Terminator, F, Complete);
      pragma Assert (Complete);
      pragma Assert
        (F.Length = (if Data'Length > Max_Frame then 0 else Data'Length));
      pragma Assert (for all I in 1 .. F.Length => F.Data (I) = Data (I));
      Answer := Decode (F, Pending);
      pragma Assert (if F.Length < 2 then Answer.Kind = Malformed);
      pragma Assert
        (Is_Answer (Answer.Kind, Pending)
         or else Answer.Kind in Refused | Unknown_Command
         or else Answer.Kind in Failed_Reply);
   end Prove_Reception;

end Robot.Protocol.Proof;
