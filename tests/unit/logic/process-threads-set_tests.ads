--  SPDX-License-Identifier: GPL-3.0-or-later
--  The processors of the real-time tasks and of all other threads.

procedure Process.Threads.Set_Tests;
