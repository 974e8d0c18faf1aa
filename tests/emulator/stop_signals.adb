--  SPDX-License-Identifier: GPL-3.0-or-later
--  What ends the emulator.

package body Stop_Signals is

   protected body Stop is

      procedure Handle is
      begin
         Requested := True;
      end Handle;

      procedure Request is
      begin
         Requested := True;
      end Request;

      entry Wait when Requested is
      begin
         null;
      end Wait;

   end Stop;

end Stop_Signals;
