--  SPDX-License-Identifier: GPL-3.0-or-later
--  From the initial state, for any sequence of orders and events: exactly one
--  image is sent between an arena order and its decision (the one with the
--  arena, once it is found; no periodic ones), and an arena is in use only
--  from its confirmation to the next rejection or closing of the camera.

package Vision.Mode.Proof with SPARK_Mode, Ghost is

   type History is array (Positive range <>) of Change;

   procedure Prove_Arena (Changes : History);
   --  Asserted in the body. A change that is not possible has no effect

end Vision.Mode.Proof;
