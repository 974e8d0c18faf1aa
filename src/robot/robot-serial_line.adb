--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time; use Ada.Real_Time;
with Process.Devices;
with Robot.Serial_Line.Calls;
with Trace;

package body Robot.Serial_Line with
  SPARK_Mode,
  Refined_State => (Device => Descriptor)
is

   Descriptor : Calls.Outcome := Calls.No_Descriptor
     with Atomic, Async_Readers, Async_Writers, Export, Convention => C,
          External_Name => "destijl_robot_line";
   --  In a crash its handler writes there (crash_handlers.cpp)

   procedure Open
     (Path : Texts.Text; Success : out Boolean; Reason : out Texts.Text)
   is
      Opened  : Calls.Outcome;
      Ignored : Boolean;
      Owner   : Texts.Text;
   begin
      Close (Ignored);
      Calls.Open (Texts.Image (Path), Opened);
      Success := Opened >= 0;
      Texts.Set (Reason, "");
      if Success then
         Descriptor := Opened;
         Calls.Discard (Opened, Calls.Received);
      elsif Opened in Calls.Busy | Calls.No_Data then
         Process.Devices.Get_Owner (Path, Owner);
         Texts.Set (Reason, "in use by " & Texts.Image (Owner));
      elsif Opened = Calls.No_Terminal then
         Texts.Set (Reason, "not a serial line");
      else
         Process.Describe (-Opened, Reason);
         if Opened = Calls.Not_Permitted then
            Texts.Append (Reason, ": your user must be in the group dialout");
         end if;
      end if;
   end Open;

   procedure Close (All_Sent : out Boolean) is
      Old    : constant Calls.Outcome := Descriptor;
      Unsent : Calls.Outcome;
      Now    : Time;
      Limit  : Time;
   begin
      All_Sent := True;
      if Old = Calls.No_Descriptor then
         return;
      end if;
      Descriptor := Calls.No_Descriptor;
      Now := Clock;
      Limit := Now + Schedule.Unsent_Limit;
      loop
         Calls.Get_Unsent (Old, Unsent);
         exit when Unsent <= 0 or else Now >= Limit;
         delay until Now + Schedule.Release_Poll;
         Now := Clock;
      end loop;
      if Unsent > 0 then
         All_Sent := False;
         Calls.Discard (Old, Calls.Written);
      end if;
      Calls.Close (Old);
   end Close;

   procedure Discard_Input is
      Line : constant Calls.Outcome := Descriptor;
   begin
      Calls.Discard (Line, Calls.Received);
   end Discard_Input;

   procedure Write
     (Who    : Schedule.Thread_Name;
      Item   : Protocol.Command;
      Mode   : Session.Mode_Kind;
      Length : out Protocol.Frame_Length)
   is
      pragma Unreferenced (Mode);
      Line  : constant Calls.Outcome := Descriptor;
      Frame : Protocol.Frame;
      Sent  : Calls.Outcome;
   begin
      Protocol.Encode (Item, Frame);
      Calls.Write (Line, Frame.Data, Frame.Length, Sent);
      Length := (if Sent = Frame.Length then Frame.Length else 0);
      Trace.Put
        (Trace.Ordered, Who,
         Label => Protocol.Letter (Item.Kind) & "     ");
   end Write;

   procedure Read
     (Data       : out Bytes.Byte_Array;
      Length     : out Natural;
      Until_Time : Time;
      Gone       : out Boolean)
   is
      Line   : constant Calls.Outcome := Descriptor;
      Result : Calls.Outcome;
      Now    : Time;
   begin
      Data := (others => 0);
      --  Ends because the clock goes on: each pass but the last begins before
      --  Until_Time, or was interrupted by a signal. GNATprove does not know
      --  that of the clock
      loop
         Now := Clock;
         Calls.Read
           (Line,
            (if Now < Until_Time then Until_Time - Now else Time_Span_Zero),
            Data, Result);
         exit when Result not in Calls.No_Data | Calls.Interrupted
           or else (Result = Calls.No_Data and then Until_Time <= Now);
      end loop;
      Length := Integer'Max (0, Result);
      Gone := Result <= 0 and then Result /= Calls.No_Data;
   end Read;

   procedure Send_Stop
     (Path : Texts.Text; Sent : out Boolean; Report : out Texts.Text)
   is
      Reason   : Texts.Text;
      Length   : Protocol.Frame_Length;
      All_Sent : Boolean;
   begin
      Open (Path, Sent, Reason);
      if Sent then
         Write (Schedule.Main, Protocol.Stop, Session.Not_Started, Length);
         Close (All_Sent);
         Sent := Length > 0 and then All_Sent;
         Texts.Set (Reason, "it takes nothing");
      end if;
      Texts.Set
        (Report,
         (if Sent then "the robot was sent a stop on " & Texts.Image (Path)
          else "no stop was sent on " & Texts.Image (Path) & ": "
            & Texts.Image (Reason)));
   end Send_Stop;

   procedure Stop_Blindly is
      Ignored : Protocol.Frame_Length;
   begin
      Write (Schedule.Th_Stop, Protocol.Stop, Session.Not_Started, Ignored);
   end Stop_Blindly;

end Robot.Serial_Line;
