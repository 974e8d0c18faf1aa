--  SPDX-License-Identifier: GPL-3.0-or-later

with Bytes;
with Interfaces.C;
with Robot.Protocol;

package body Crashes with SPARK_Mode => Off is
   --  Off: what it calls is in crash_handlers.cpp

   procedure Catch_With (Stop : Bytes.Byte_Array; Length : Interfaces.C.int)
   with Import, Convention => C, External_Name => "destijl_catch_crashes";

   procedure Catch is
      Frame : Robot.Protocol.Frame;
   begin
      Robot.Protocol.Encode (Robot.Protocol.Stop, Frame);
      Catch_With (Frame.Data, Interfaces.C.int (Frame.Length));
   end Catch;

end Crashes;
