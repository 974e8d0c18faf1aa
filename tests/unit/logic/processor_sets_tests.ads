--  SPDX-License-Identifier: GPL-3.0-or-later
--  Which processors the real-time tasks have, and which all others.

package Processor_Sets_Tests is

   procedure Add_Tests;

end Processor_Sets_Tests;
