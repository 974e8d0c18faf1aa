--  SPDX-License-Identifier: GPL-3.0-or-later
--  Mutual exclusion for operations that may block, such as output, and so are
--  not allowed inside a protected action.

package Mutexes is

   protected type Mutex is

      entry Seize;

      procedure Release;

   private
      Taken : Boolean := False;
   end Mutex;

end Mutexes;
