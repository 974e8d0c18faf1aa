--  SPDX-License-Identifier: GPL-3.0-or-later
--  F14, F15: cameras of every rate, and V4L2 cameras of every kind.

package Source_Tests is

   procedure Register;

end Source_Tests;
