--  SPDX-License-Identifier: GPL-3.0-or-later

with Admission.Authentication;
with Admission.Secret_Files;
with Console;
with Monitor.Sockets.Gate;
with Process.Privileges;
with Robot.Serial_Line;
with Texts;
with Trace;
with Vision.Library;

package body Checks with SPARK_Mode is

   use type Process.Privileges.Scheduling;
   use type Vision.Library.Status;

   procedure Report (Good : Boolean; Line : String; All_Well : in out Boolean);
   --  All_Well is unchanged if Good, and the line could be written

   function Number (Value : Integer) return Texts.Text;
   --  Value in decimal

   function Number (Value : Integer) return Texts.Text is
      Result : Texts.Text;
   begin
      Texts.Append (Result, Value);
      return Result;
   end Number;

   procedure Report (Good : Boolean; Line : String; All_Well : in out Boolean)
   is
      Written : Boolean;
   begin
      Console.Put
        ((if Good then "ok      " else "not ok  ") & Line, Written);
      All_Well := All_Well and Good;
      if not Written then
         All_Well := False;
      end if;
   end Report;

   procedure Run (Chosen : Options.Values; All_Well : out Boolean) is
      Granted : Process.Privileges.Scheduling;
      Good    : Boolean;
      Ignored : Boolean;
      Reason  : Texts.Text;
      Bound   : Options.Port_Number;
      Result  : Vision.Library.Status;
      Why     : Vision.Library.Reason_Text;
      Last    : Natural;
      Token   : Admission.Authentication.Token;
   begin
      All_Well := True;
      Process.Privileges.Get (Granted);
      Report
        (Granted = Process.Privileges.Fifo_With_Ceilings,
         "real-time priorities: " & Process.Privileges.Image (Granted)
         & (if Granted in Process.Privileges.Fifo_Without_Ceilings
                        | Process.Privileges.Not_Permitted
            then ": run as root with CAP_SYS_NICE (in a container --cap-add "
              & "SYS_NICE), or once "
              & "'sudo setcap cap_sys_nice,cap_ipc_lock+ep bin/destijl'"
            elsif Granted = Process.Privileges.Refused
            then ": see 'Troubleshooting' in the manual"
            else ""),
         All_Well);

      Robot.Serial_Line.Open (Chosen.Serial, Good, Reason);
      Robot.Serial_Line.Close (Ignored);
      Report
        (Good,
         "serial line " & Texts.Image (Chosen.Serial)
         & (if Good then ": opens"
            else ": " & Texts.Image (Reason)
              & " (name another with --serial)"),
         All_Well);

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
            else " " & Why (1 .. Last) & " (name another with --camera)"),
         All_Well);

      Admission.Secret_Files.Read_Token
        (Chosen.Token_File, Token, Good, Reason);
      if Token.Length > 0 then
         Report
           (True, "token file " & Texts.Image (Chosen.Token_File)
            & ": holds a token",
            All_Well);
      elsif not Good then
         Report
           (False, "token file " & Texts.Image (Chosen.Token_File) & ": "
            & Texts.Image (Reason),
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

      Monitor.Sockets.Gate.Listen
        (Chosen.Bind, Chosen.Port, Bound, Good, Reason);
      Report
        (Good,
         "port " & Texts.Image (Chosen.Bind) & ":"
         & (if Good then Texts.Image (Number (Bound)) & " is free"
            else Texts.Image (Number (Chosen.Port)) & ": "
              & Texts.Image (Reason)
              & " (choose another with --port or --bind)"),
         All_Well);
   end Run;

end Checks;
