--  SPDX-License-Identifier: GPL-3.0-or-later
--  How much the supervisor can do: images a second at each size, commands a
--  second; and what it takes of the processors at its ordinary pace.

package Scale_Limits is

   procedure Report;

end Scale_Limits;
