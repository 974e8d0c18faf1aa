--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time; use Ada.Real_Time;
with Interfaces;    use Interfaces;
with Process.Files;
with Trace.Ring;    use Trace.Ring;

package body Trace with
  SPARK_Mode,
  Refined_State => (Recorder => (On, File, First, Trace.Ring.Memory))
is

   use type Commands.Ticket;

   On    : Boolean := False
     with Atomic, Async_Readers, Async_Writers;
   File  : Process.Files.Descriptor := 0
     with Atomic, Async_Readers, Async_Writers;
   First : Time := Time_First
     with Atomic, Async_Readers, Async_Writers;
   --  When the recording began

   Longest : constant := 80;
   --  No line is longer

   procedure Try
     (Path : Texts.Text; Success : out Boolean; Reason : out Texts.Text)
   is
      Opened : Process.Files.Outcome;
   begin
      Process.Files.Open (Path, Process.Files.None, Opened);
      if Opened = -Process.Files.Not_Found then
         Process.Files.Open (Path, Process.Files.New_Only, Opened);
         if Opened >= 0 then
            Process.Files.Remove (Path);
         end if;
      end if;
      Success := Opened >= 0;
      Process.Describe (-Integer'Min (0, Opened), Reason);
      if Success then
         Process.Files.Close (Opened);
      end if;
   end Try;

   procedure Open
     (Path : Texts.Text; Success : out Boolean; Reason : out Texts.Text)
   is
      Opened : Process.Files.Outcome;
      Now    : Time;
   begin
      Process.Files.Open (Path, Process.Files.New_Also, Opened);
      Success := Opened >= 0;
      Process.Describe (-Integer'Min (0, Opened), Reason);
      if Success then
         File := Opened;
         Process.Files.Empty (Opened);
         Ring.Reset;
         Ring.Get_Time (Now);
         First := Now;
         On := True;
      end if;
   end Open;

   procedure Write
     (Into  : Process.Files.Descriptor;
      Text  : Texts.Text;
      Error : in out Process.Files.Error_Number)
   with Global => (In_Out => Process.System_State)
   is
      --  No effect after an Error
      Done   : Natural := 0;
      Result : Process.Files.Outcome;
   begin
      while Error = 0 and then Done < Text.Length loop
         pragma Loop_Invariant (Done < Text.Length);
         pragma Loop_Variant (Increases => Done);
         Process.Files.Write
           (Into, Text.Data (Done + 1 .. Text.Length), Result);
         if Result > 0 then
            Done := Done + Result;
         else
            Error := (if Result < 0 then -Result
                      else Process.Files.Io_Failure);
         end if;
      end loop;
   end Write;

   procedure Append_Time (Line : in out Texts.Text; Value : Time)
   with Global => null
   is
      --  Value, as seconds of the clock with nine decimals
      Whole    : Seconds_Count;
      Rest     : Time_Span;
      Fraction : Texts.Text;
   begin
      Split (Value, Whole, Rest);
      Texts.Append
        (Line,
         Natural
           (Seconds_Count'Max
              (0, Seconds_Count'Min (Whole, Seconds_Count (Natural'Last)))));
      Texts.Append
        (Fraction,
         1_000_000_000
         + Integer'Max (0, Integer'Min (Rest / Nanoseconds (1), 999_999_999)));
      Fraction.Data (1) := '.';  --  for the 1, which has kept the zeros
      Texts.Append (Line, Texts.Image (Fraction));
   end Append_Time;

   procedure Append_Event
     (Text : in out Texts.Text; Begun : Time; Item : Event)
   with Global => null
   is
      --  The line of the file for Item, with the time since Begun
   begin
      Append_Time
        (Text,
         Time_Of (0, (if Item.At_Time > Begun then Item.At_Time - Begun
                      else Time_Span_Zero)));
      Texts.Append (Text, " " & Schedule.Name_Of (Item.Who) & " ");
      Texts.Append
        (Text,
         (case Item.Kind is
             when Release  => "release",
             when Due      => "due",
             when Start    => "start",
             when Take     => "take",
             when Done     => "done",
             when Wait     => "wait",
             when Resume   => "resume",
             when Received => "in",
             when Sent     => "out",
             when Ordered  => "robot"));
      if Item.Label /= No_Label then
         Texts.Append (Text, " ");
         for C of Item.Label loop
            exit when C = ' ';
            Texts.Append (Text, (1 => C));
         end loop;
      end if;
      if Item.Number > 0 then
         Texts.Append (Text, " #");
         Texts.Append
           (Text,
            Natural
              (Commands.Ticket'Min
                 (Item.Number, Commands.Ticket (Natural'Last))));
      end if;
      Texts.Append (Text, (1 => ASCII.LF));
   end Append_Event;

   procedure Write_File
     (Into    : Process.Files.Descriptor;
      Limit   : Time;
      In_Time : out Boolean;
      Error   : out Process.Files.Error_Number)
   is
      --  Until Limit
      Begun    : constant Time := First;
      Recorded : Event_Number;
      Number   : Event_Number;
      Item     : Event;
      Found    : Boolean;
      Text     : Texts.Text;
      Now      : Time;
   begin
      In_Time := True;
      Error := 0;
      Process.Files.Empty (Into);
      Texts.Set (Text, "# destijl trace, begun at ");
      Append_Time (Text, Begun);
      Texts.Append (Text, " of CLOCK_MONOTONIC" & ASCII.LF);
      for Who in Schedule.Task_Name loop
         Texts.Append (Text, "# task " & Schedule.Name_Of (Who) & " ");
         Texts.Append (Text, Schedule.Table (Who).Priority);
         Texts.Append (Text, (1 => ASCII.LF));
         Write (Into, Text, Error);
         Text.Length := 0;
      end loop;
      Ring.Get_Count (Recorded);
      Texts.Append (Text, "# recorded ");
      Texts.Append
        (Text,
         Natural (Event_Number'Min (Recorded, Event_Number (Natural'Last))));
      Texts.Append (Text, (1 => ASCII.LF));
      Number := (if Recorded > Capacity then Recorded - Capacity else 0);
      while Number < Recorded and then In_Time and then Error = 0 loop
         pragma Loop_Variant (Increases => Number);
         Ring.Get (Number, Item, Found);
         if Found then
            Append_Event (Text, Begun, Item);
         end if;
         Number := Number + 1;
         if Text.Length > Texts.Max_Length - Longest then
            Write (Into, Text, Error);
            Text.Length := 0;
            Now := Clock;
            In_Time := Now < Limit;
         end if;
      end loop;
      Write (Into, Text, Error);
   end Write_File;

   procedure Finish (Whole : out Boolean; Reason : out Texts.Text) is
      Now       : constant Time := Clock;
      Recording : constant Boolean := On;
      Into      : constant Process.Files.Descriptor := File;
      Error     : Process.Files.Error_Number;
   begin
      Whole := True;
      Texts.Set (Reason, "");
      if Recording then
         On := False;
         --  not urgent any more, and it takes long
         Process.Give_Up_Priority;
         Write_File (Into, Now + Schedule.Trace_Limit, Whole, Error);
         if Error > 0 then
            Whole := False;
            Process.Describe (Error, Reason);
         elsif not Whole then
            Texts.Set (Reason, "it takes too long");
         end if;
      end if;
   end Finish;

   procedure Put
     (Kind   : Event_Kind;
      Who    : Schedule.Thread_Name;
      Number : Commands.Ticket := 0;
      Label  : Label_Text := No_Label)
   is
      Recording : constant Boolean := On;
      Now       : Time;
   begin
      if Recording and then Who in Schedule.Task_Name then
         Ring.Get_Time (Now);
         Ring.Put ((Now, Number, Who, Kind, Label));
      end if;
   end Put;

   procedure Put_Due (Who : Schedule.Thread_Name; At_Time : Time) is
      Recording : constant Boolean := On;
   begin
      if Recording and then Who in Schedule.Task_Name then
         Ring.Put ((At_Time, 0, Who, Due, No_Label));
      end if;
   end Put_Due;

end Trace;
