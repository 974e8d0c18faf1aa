--  SPDX-License-Identifier: GPL-3.0-or-later

package body Vision.Camera_Demands with SPARK_Mode is

   procedure Ask (S : in out State) is
   begin
      S := (S.Current + 1, True, True, S.Held);
   end Ask;

   procedure Withdraw (S : in out State) is
   begin
      S.Wanted := False;
   end Withdraw;

   procedure Take
     (S : in out State; Number : out Request_Number; Found : out Boolean) is
   begin
      Found := S.Pending;
      Number := S.Current;
      S.Pending := False;
      S.Held := S.Held or else Found;
   end Take;

   procedure Release (S : in out State) is
   begin
      S.Held := False;
   end Release;

end Vision.Camera_Demands;
