--  SPDX-License-Identifier: GPL-3.0-or-later
--  Requests to end the emulator: SIGTERM, SIGINT, or `quit`.

with Ada.Interrupts.Names;

package Stop_Signals is

   pragma Unreserve_All_Interrupts;
   --  SIGINT is also handled here

   protected Stop is

      procedure Request;

      entry Wait;
      --  For the request

   private
      procedure Handle;
      pragma Attach_Handler (Handle, Ada.Interrupts.Names.SIGTERM);
      pragma Attach_Handler (Handle, Ada.Interrupts.Names.SIGINT);

      Requested : Boolean := False;
   end Stop;

end Stop_Signals;
