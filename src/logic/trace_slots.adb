--  SPDX-License-Identifier: GPL-3.0-or-later

package body Trace_Slots with SPARK_Mode is

   procedure Prove_States (Old, Number : Event_Number) is null;

end Trace_Slots;
