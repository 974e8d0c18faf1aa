--  SPDX-License-Identifier: GPL-3.0-or-later

with Interfaces;   use Interfaces;
with Interfaces.C; use Interfaces.C;
with Linux;
with Schedule;
with System;

package body Process.Signals with SPARK_Mode => Off is
   --  Off: addresses are passed to C

   type Signal_Set is array (1 .. 16) of Unsigned_64 with Convention => C;
   --  1024 bits, as glibc's, from signal 1 on

   function Bit (Signal : int) return Unsigned_64 is
     (Shift_Left (1, Integer (Signal) - 1));

   Hang_Up  : constant int := 1;
   Internal : constant int := 34;  --  SIGRTMIN

   --  All others that would end or stop the process: SIGINT, SIGQUIT, SIGUSR1,
   --  SIGUSR2, SIGALRM, SIGTERM, SIGSTKFLT, SIGTSTP, SIGXCPU, SIGVTALRM,
   --  SIGPROF, SIGIO, SIGPWR, and those from SIGRTMIN + 1 to SIGRTMAX
   To_Stop : constant Unsigned_64 :=
     Bit (2) + Bit (3) + Bit (10) + Bit (12) + Bit (14) + Bit (15) + Bit (16)
     + Bit (20) + Bit (24) + Bit (26) + Bit (27) + Bit (29) + Bit (30)
     + Shift_Left (2 ** 30 - 1, Integer (Internal));

   --  SIGPIPE, SIGTTIN, SIGTTOU, SIGXFSZ: the call that causes one fails
   To_Discard : constant Unsigned_64 :=
     Bit (13) + Bit (21) + Bit (22) + Bit (25);

   Blocked : Signal_Set :=
     (1      => Bit (Hang_Up) + Bit (Internal) + To_Stop + To_Discard,
      others => 0);

   type Signal_Action is array (1 .. 32) of unsigned_long with Convention => C;
   --  At least as long as glibc's; it begins with the handler

   Ignore : constant unsigned_long := 1;  --  SIG_IGN

   procedure Get_Action (Signal : int; New_One, Old : System.Address)
   with Import, Convention => C, External_Name => "sigaction";

   procedure Add_To_Mask (How : int; Set, Old : System.Address)
   with Import, Convention => C, External_Name => "pthread_sigmask";

   function Get_Next (Set, Signal : System.Address) return int
   with Import, Convention => C, External_Name => "sigwait";

   procedure Send (Process : int; Signal : int)
   with Import, Convention => C, External_Name => "kill";

   procedure Report_Failure is
   begin
      Send (Linux.Own_Process, Internal);
   end Report_Failure;

   procedure Wait (Signal : out Kind) is
      Number : int := 0;
   begin
      Trace.Put (Trace.Done, Schedule.Th_Stop);
      loop
         exit when Get_Next (Blocked'Address, Number'Address) = 0
           and then (Bit (Number) and To_Discard) = 0;
      end loop;
      Trace.Put (Trace.Start, Schedule.Th_Stop);
      Signal := (if Number = Internal then Failure else Stop_Request);
   end Wait;

   Action : Signal_Action := (others => 0);

begin
   Get_Action (Hang_Up, System.Null_Address, Action'Address);
   if Action (1) = Ignore then
      Blocked (1) := Blocked (1) - Bit (Hang_Up);  --  as nohup wants it
   end if;
   Add_To_Mask (0, Blocked'Address, System.Null_Address);  --  SIG_BLOCK
end Process.Signals;
