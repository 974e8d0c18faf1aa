--  SPDX-License-Identifier: GPL-3.0-or-later
--  The machine that the process runs on.

with Texts;

package Process.Machine with SPARK_Mode is

   procedure Get_Kernel (Name, Version : out Texts.Text)
   with Global => (In_Out => System_State);
   --  Such as "6.1.0-18-amd64", "#1 SMP PREEMPT_DYNAMIC Debian 6.1.76-1"

   procedure Get_Memory (Megabytes : out Natural)
   with Global => (In_Out => System_State);
   --  Of the whole machine

end Process.Machine;
