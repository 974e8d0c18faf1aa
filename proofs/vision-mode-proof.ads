--  SPDX-License-Identifier: GPL-3.0-or-later
--  From the initial state, for any sequence of orders and events: exactly one
--  image is sent between an arena order and its decision (the one with the
--  arena, once it is found; no periodic ones), and an arena is in use only
--  from its confirmation to the next rejection or closing of the camera.

package Vision.Mode.Proof with SPARK_Mode, Ghost is

   type Event is
     (Open_Order,
      Camera_Opened,
      Camera_Missing,
      Camera_Closed,
      Arena_Order,
      Arena_Found,
      No_Arena_Found,
      Confirmation,
      Rejection,
      Position_Order,
      Position_End,
      Image_Due);        --  the period of the images

   type History is array (Positive range <>) of Event;

   procedure Prove_Arena (Events : History);
   --  Asserted in the body

end Vision.Mode.Proof;
