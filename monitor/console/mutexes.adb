--  SPDX-License-Identifier: GPL-3.0-or-later
--  Mutual exclusion for what may block.

package body Mutexes is

   protected body Mutex is

      entry Seize when not Taken is
      begin
         Taken := True;
      end Seize;

      procedure Release is
      begin
         Taken := False;
      end Release;

   end Mutex;

end Mutexes;
