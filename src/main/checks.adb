--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Admission;
with Admission.Secret_Files;
with Console;
with Monitor.Sockets;
with Process.Devices;
with Process.Privileges;
with Robot.Serial_Line;
with Texts;
with Trace;
with Vision.Library;

package body Checks with SPARK_Mode is

   use type Process.Privileges.Scheduling;
   use type Vision.Library.Status;

   Program   : constant Texts.Text := Process.Program;
   Installed : constant Boolean :=
     Index (Texts.Image (Program), "/") = 0
     or else (Program.Length >= 5 and then Program.Data (1 .. 5) = "/usr/");
   --  Not in a clone: there it is called with a path

   function In_Settings return String is
     (if Installed then " in /etc/default/destijl" else "");
   --  Where the service has its options

   function Number (Value : Integer) return Texts.Text is
      --  Value in decimal
      Result : Texts.Text;
   begin
      Texts.Append (Result, Value);
      return Result;
   end Number;

   procedure Report (Good : Boolean; Line : String; All_Well : in out Boolean)
   is
      --  All_Well is unchanged if Good, and the line could be written
      Written : Boolean;
   begin
      Console.Put
        ((if Good then "ok      " else "not ok  ") & Line, Written);
      All_Well := All_Well and Good and Written;
   end Report;

   procedure Check_Line (Path : Texts.Text; All_Well : in out Boolean) is
      Good    : Boolean := False;
      Reason  : Texts.Text;
      Ignored : Boolean;
   begin
      --  a console is left alone: messages would come in between, anyway
      Process.Devices.Get_Use (Path, Reason);
      if Reason.Length > 0 then
         Texts.Append (Reason, ": see 'Troubleshooting' in the manual");
      else
         Robot.Serial_Line.Open (Path, Good, Reason);
         Robot.Serial_Line.Close (Ignored);
         Texts.Append (Reason, " (name another with --serial");
         Texts.Append
           (Reason,
            (if Installed then ", DESTIJL_SERIAL" & In_Settings else ""));
         Texts.Append (Reason, ")");
      end if;
      Report
        (Good,
         "serial line " & Texts.Image (Path) & ": "
         & (if Good then "opens" else Texts.Image (Reason)),
         All_Well);
   end Check_Line;

   procedure Check_Machine (All_Well : in out Boolean) is
      --  Priorities, memory, kernel
      Granted  : Process.Privileges.Scheduling;
      May_Lock : Boolean;
      Size     : Natural;
      Kernel   : Texts.Text;
      Version  : Texts.Text;
   begin
      Process.Privileges.Get (Granted);
      Report
        (Granted = Process.Privileges.Fifo_With_Ceilings,
         "real-time priorities: " & Process.Privileges.Image (Granted)
         & (if Granted in Process.Privileges.Fifo_Without_Ceilings
                        | Process.Privileges.Not_Permitted
            then
              (if Installed then ": the service has them (systemctl start "
                 & "destijl)"
               else ": run as root with CAP_SYS_NICE (in a container "
                 & "--cap-add SYS_NICE), or once 'sudo setcap "
                 & "cap_sys_nice,cap_ipc_lock+ep " & Texts.Image (Program)
                 & "'")
            elsif Granted = Process.Privileges.Refused
            then ": see 'Troubleshooting' in the manual"
            else ""),
         All_Well);
      Process.Privileges.Get_May_Lock (May_Lock);
      Process.Get_Memory (Size);
      Report
        (May_Lock,
         "memory: " & Texts.Image (Number (Size)) & " MB, "
         & (if May_Lock then "can be locked"
            else "cannot be locked (CAP_IPC_LOCK, LimitMEMLOCK=infinity)"),
         All_Well);
      Process.Get_Kernel (Kernel, Version);
      Report
        (True,
         "kernel " & Texts.Image (Kernel) & ": "
         & (if Index (Texts.Image (Version), "PREEMPT_RT") > 0 then ""
            else "not ") & "PREEMPT_RT",
         All_Well);
   end Check_Machine;

   procedure Run (Chosen : Options.Values; All_Well : out Boolean) is
      Good    : Boolean;
      Reason  : Texts.Text;
      Bound   : Options.Port_Number;
      Result  : Vision.Library.Status;
      Why     : Vision.Library.Reason_Text;
      Last    : Natural;
      Token   : Admission.Token;
   begin
      All_Well := True;
      Check_Machine (All_Well);
      Check_Line (Chosen.Serial, All_Well);
      Vision.Library.Open
        (Texts.Image (Chosen.Camera), Chosen.Width, Chosen.Height,
         Integer'Max (Options.Camera_Rate, Chosen.Frame_Rate), Result);
      if Result = Vision.Library.Done then
         Vision.Library.Grab (0, Result);
      end if;
      if Result = Vision.Library.Done then
         Vision.Library.Get_Format (Why, Last);
      else
         Vision.Library.Reason (Why, Last);
      end if;
      Vision.Library.Close;
      Good := Result = Vision.Library.Done;
      Report
        (Good,
         "camera"
         & (if Good then ": delivers images"
              & (if Last > 0 then ", " & Why (1 .. Last) else "")
            --  with its name, without secrets
            else " " & Why (1 .. Last) & " (name another with --camera"
              & In_Settings & ")"),
         All_Well);

      if Chosen.Token_File.Length > 0 then
         Admission.Secret_Files.Read_Token (Chosen.Token_File, Token, Reason);
         Good := Token.Length > 0;
         Report
           (Good, "token file " & Texts.Image (Chosen.Token_File) & ": "
            & (if Good then "holds a token" else Texts.Image (Reason)),
            All_Well);
      end if;

      if Chosen.Trace_File.Length > 0 then
         Trace.Try (Chosen.Trace_File, Good, Reason);
         Report
           (Good, "trace file " & Texts.Image (Chosen.Trace_File)
            & (if Good then ": can be written"
               else ": " & Texts.Image (Reason)),
            All_Well);
      end if;

      Monitor.Sockets.Listen
        (Chosen.Bind, Chosen.Port, Bound, Good, Reason);
      Report
        (Good,
         "port " & Texts.Image (Chosen.Bind) & ":"
         & (if Good then Texts.Image (Number (Bound)) & " is free"
            else Texts.Image (Number (Chosen.Port)) & ": "
              & Texts.Image (Reason)
              & " (choose another with --port or --bind" & In_Settings
              & ")"),
         All_Well);
   end Run;

end Checks;
