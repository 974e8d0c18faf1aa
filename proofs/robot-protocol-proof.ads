--  SPDX-License-Identifier: GPL-3.0-or-later
--  Whatever the line delivers is understood, or refused as malformed.

package Robot.Protocol.Proof with SPARK_Mode, Ghost is

   procedure Prove_Reception (Data : Byte_Array; Pending : Command_Kind)
   with
     Pre => Data'First = 1
       and then Data'Last < Integer'Last
       and then (for all B of Data => B /= Terminator);
   --  Any bytes before a terminator make one frame: these bytes, or one that
   --  is too long. Decode turns it into an answer to Pending, a refusal, or a
   --  failure. Asserted in the body.

end Robot.Protocol.Proof;
