--  SPDX-License-Identifier: GPL-3.0-or-later
--  The priority of the thread that measures.

with Interfaces.C; use Interfaces.C;

with Libc;

package body Own_Priority is

   ----------------------
   -- Prefer_Real_Time --
   ----------------------

   procedure Prefer_Real_Time (Wanted : Boolean) is
      Highest : aliased Libc.Sched_Param :=
        (Priority => Libc.Above_Supervisor);
      None    : aliased Libc.Sched_Param := (Priority => 0);
      Unused  : int;
   begin
      if Wanted then
         Unused := Libc.Sched_Setscheduler
           (0, Libc.Sched_Fifo, Highest'Access);
      else
         Unused := Libc.Sched_Setscheduler
           (0, Libc.Sched_Other, None'Access);
      end if;
   end Prefer_Real_Time;

   -----------------------
   -- Real_Time_Allowed --
   -----------------------

   function Real_Time_Allowed return Boolean is
      Lowest : aliased Libc.Sched_Param := (Priority => 1);
      None   : aliased Libc.Sched_Param := (Priority => 0);
   begin
      return
        Libc.Sched_Setscheduler (0, Libc.Sched_Fifo, Lowest'Access) = 0
        and then Libc.Sched_Setscheduler
          (0, Libc.Sched_Other, None'Access) = 0;
   end Real_Time_Allowed;

end Own_Priority;
