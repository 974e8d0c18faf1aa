--  SPDX-License-Identifier: GPL-3.0-or-later
--  The place for one message that carries an image, on its way to the
--  monitor: a newer one takes the place of an older one.

package body Image_Slots with SPARK_Mode is

   -----------
   -- Clear --
   -----------

   procedure Clear (S : in out Slot) is
   begin
      S.Length := 0;
   end Clear;

   ---------
   -- Get --
   ---------

   procedure Get
     (S : Slot; Data : in out Message_Buffer; Length : out Message_Length) is
   begin
      Length := S.Length;
      Data (1 .. Length) := S.Data (1 .. Length);
   end Get;

   ---------
   -- Put --
   ---------

   procedure Put
     (S : in out Slot; Data : Message_Buffer; Length : Message_Length) is
   begin
      S.Length := Length;
      S.Data (1 .. Length) := Data (1 .. Length);
   end Put;

end Image_Slots;
