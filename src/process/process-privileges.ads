--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the system lets the process do.

with Schedule;

package Process.Privileges with SPARK_Mode is

   type Scheduling is
     (Fifo_With_Ceilings, Fifo_Without_Ceilings, Not_Permitted, Refused);
   --  Priorities act for all tasks, or for none. With ceilings: the highest
   --  priority of Linux is granted. Refused: not granted though permitted

   Needed_Limit : constant := Schedule.Stop_Priority + 1;
   --  RLIMIT_RTPRIO of all tasks: GNAT's priorities are Linux's less one

   function Image (Granted : Scheduling) return String is
     (case Granted is
         when Fifo_With_Ceilings    => "FIFO, ceilings",
         when Fifo_Without_Ceilings =>
            "FIFO, no ceilings (RLIMIT_RTPRIO, no CAP_SYS_NICE)",
         when Not_Permitted         =>
            "none (no CAP_SYS_NICE, RLIMIT_RTPRIO below"
            & Integer'Image (Needed_Limit) & ")",
         when Refused               =>
            "none (refused by the kernel: CONFIG_RT_GROUP_SCHED, a namespace "
            & "of users; or by a filter: seccomp, RestrictRealtime=)");

   procedure Get (Granted : out Scheduling)
   with Global => (In_Out => System_State);
   --  Found out at the start, by trying

   procedure Get_May_Lock (May_Lock : out Boolean)
   with Global => (In_Out => System_State);
   --  Whether it may lock as much memory as it likes (CAP_IPC_LOCK,
   --  RLIMIT_MEMLOCK)

   procedure Lock_Memory (Done : out Boolean)
   with Global => (In_Out => System_State);
   --  From here on, what this process has once used stays in memory, and so
   --  does all of the program's own code. Done is false where it may not
   --  lock as much as it likes

end Process.Privileges;
