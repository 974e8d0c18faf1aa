--  SPDX-License-Identifier: GPL-3.0-or-later
--  Who else uses a device: another program, the kernel, a login.

package Process.Devices with SPARK_Mode is

   procedure Get_Owner (Path : Texts.Text; Owner : out Texts.Text);
   --  Of an advisory lock (flock) of the device: a program and the number of
   --  its process; "another program" if that is not known

   procedure Get_Use (Path : Texts.Text; Used : out Texts.Text);
   --  What else the device is for: a console of the kernel, a login; empty if
   --  nothing is known

end Process.Devices;
