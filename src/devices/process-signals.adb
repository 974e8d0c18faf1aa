--  SPDX-License-Identifier: GPL-3.0-or-later

with Interfaces;   use Interfaces;
with Interfaces.C; use Interfaces.C;
with Linux;
with System;

package body Process.Signals with SPARK_Mode => Off is

   type Signal_Set is array (1 .. 16) of Unsigned_64 with Convention => C;
   --  1024 bits, as glibc's, from signal 1 on

   User_1      : constant int := 10;
   Broken_Pipe : constant int := 13;

   Blocked : constant Signal_Set :=
     (1      => 2 ** 0 + 2 ** 1 + 2 ** 9 + 2 ** 12 + 2 ** 14,
      others => 0);
   --  SIGHUP, SIGINT, SIGUSR1, SIGPIPE, SIGTERM

   procedure Add_To_Mask (How : int; Set, Old : System.Address)
   with Import, Convention => C, External_Name => "pthread_sigmask";

   function Get_Next (Set, Signal : System.Address) return int
   with Import, Convention => C, External_Name => "sigwait";

   procedure Send (Process : int; Signal : int)
   with Import, Convention => C, External_Name => "kill";

   procedure Report_Failure is
   begin
      Send (Linux.Own_Process, User_1);
   end Report_Failure;

   procedure Wait (Signal : out Kind) is
      Number : int := 0;
   begin
      loop
         exit when Get_Next (Blocked'Address, Number'Address) = 0
           and then Number /= Broken_Pipe;
      end loop;
      Signal := (if Number = User_1 then Failure else Stop_Request);
   end Wait;

begin
   Add_To_Mask (0, Blocked'Address, System.Null_Address);  --  SIG_BLOCK
end Process.Signals;
