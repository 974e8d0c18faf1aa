--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the running program asks of the system for itself.

with System;

package body Own_Process is

   procedure Prefer_Real_Time
     (Wanted : Boolean; Priority : int := Libc.Above_Supervisor)
   is
      Param  : aliased Libc.Sched_Param :=
        (Priority => (if Wanted then Priority else 0));
      Unused : int;
   begin
      Unused := Libc.Sched_Setscheduler
        (0, (if Wanted then Libc.Sched_Fifo else Libc.Sched_Other),
         Param'Access);
   end Prefer_Real_Time;

   function Real_Time_Allowed return Boolean is
      Highest : aliased Libc.Sched_Param := (Priority => 99);
      None    : aliased Libc.Sched_Param := (Priority => 0);
   begin
      return
        Libc.Sched_Setscheduler (0, Libc.Sched_Fifo, Highest'Access) = 0
        and then Libc.Sched_Setscheduler
          (0, Libc.Sched_Other, None'Access) = 0;
   end Real_Time_Allowed;

   procedure Wake_On_Time is
   begin
      Libc.Prctl (Libc.Pr_Set_Timerslack, 1);
   end Wake_On_Time;

   procedure Give_Way is
   begin
      Libc.Nice (5);
   end Give_Way;

   procedure Lock_Memory is
      Once_Used : constant := 7;
      --  MCL_CURRENT, MCL_FUTURE, MCL_ONFAULT
   begin
      --  anybody else may lock a little, and could not get more memory then
      if Libc.Geteuid = 0 then
         Libc.Mlockall (Once_Used);
      end if;
   end Lock_Memory;

   procedure Ignore_Broken_Pipes is
      Unused : System.Address;
   begin
      Unused := Libc.Signal (Libc.Sigpipe, Libc.Ignored);
   end Ignore_Broken_Pipes;

end Own_Process;
