--  SPDX-License-Identifier: GPL-3.0-or-later
--  The place for one message that carries an image, on its way to the
--  monitor: a newer one takes the place of an older one.

package Image_Slots with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Image_Slots);
   --  A claim that GNATprove checks: every subprogram ends

   Max_Jpeg : constant := 1_048_575;
   --  Bytes of the largest image that can be sent (a multiple of 3)

   Max_Message : constant := 5 + Max_Jpeg / 3 * 4 + 1;
   --  Characters of its message: label, base64, line feed

   subtype Message_Buffer is String (1 .. Max_Message);
   subtype Message_Length is Natural range 0 .. Max_Message;

   type Slot is record
      Data   : Message_Buffer := (others => ' ');
      Length : Message_Length := 0;
   end record;
   --  The message is Data (1 .. Length). Initially there is none

   function Is_Empty (S : Slot) return Boolean is (S.Length = 0);

   procedure Put
     (S : in out Slot; Data : Message_Buffer; Length : Message_Length)
   with
     Post => S.Length = Length
       and then S.Data (1 .. Length) = Data (1 .. Length);
   --  The newest image wins: what was there is forgotten

   procedure Get
     (S : Slot; Data : in out Message_Buffer; Length : out Message_Length)
   with
     Post => Length = S.Length
       and then Data (1 .. Length) = S.Data (1 .. S.Length);

   procedure Clear (S : in out Slot)
   with Post => Is_Empty (S);

end Image_Slots;
