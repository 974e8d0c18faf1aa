--  SPDX-License-Identifier: GPL-3.0-or-later
--  The supervisor's capacity: images per second at each size, commands per
--  second; and its processor load at the ordinary rate.

package Scale_Limits is

   procedure Report;

end Scale_Limits;
