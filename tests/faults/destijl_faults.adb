--  SPDX-License-Identifier: GPL-3.0-or-later
--  Injects faults into the real supervisor and checks what must hold
--  nevertheless.

with Ada.Text_IO; use Ada.Text_IO;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Command_Line; use Ada.Command_Line;
with System;with Ada.Calendar;
with Libc;
with Faults;
with Fault_List;
with Programs;
with Trials; use Trials;

procedure Destijl_Faults is
   Unused  : System.Address;
   R : Trials.Result;
begin
   Unused := Libc.Signal (Libc.Sigpipe, Libc.Ignored);
   Fault_List.Register;
   for N in 1 .. Faults.Count loop
      if N >= Integer'Value (Argument (2)) then
      for K in 1 .. Integer'Value (Argument (1)) loop
         Trials.Run (N, 0, 1, K, R);
         Put_Line (Trials.Name (N, 0) & K'Image & " " & R.Ends_As'Image & ' ' & Ada.Calendar.Seconds (Ada.Calendar.Clock)'Image);
         Put (To_String (R.Account));
      end loop;
      end if;
   end loop;
   Trials.Finish;
   Programs.Remove_Temporary_Folder;
end Destijl_Faults;
