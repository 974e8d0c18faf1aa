--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time;     use Ada.Real_Time;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Console;
with Interfaces;        use Interfaces;
with Trace.Ring;        use Trace.Ring;

package body Trace with
  SPARK_Mode,
  Refined_State => (Recorder => (On, File, First, Trace.Ring.Memory))
is

   use type Commands.Ticket;

   On    : Boolean := False
     with Atomic, Async_Readers, Async_Writers;
   File  : Process.Descriptor := 0
     with Atomic, Async_Readers, Async_Writers;
   First : Time := Time_First
     with Atomic, Async_Readers, Async_Writers;
   --  When the recording began

   Longest : constant := 80;
   --  No line is longer

   procedure Try
     (Path : Texts.Text; Success : out Boolean; Reason : out Texts.Text)
   is
      Opened : Process.Outcome;
   begin
      Process.Open (Path, Process.Never, Opened);
      if Opened = -Process.Not_Found then
         Process.Open (Path, Process.New_Only, Opened);
         if Opened >= 0 then
            Process.Remove (Path);
         end if;
      end if;
      Success := Opened >= 0;
      Process.Describe (-Integer'Min (0, Opened), Reason);
      if Success then
         Process.Close (Opened);
      end if;
   end Try;

   procedure Open
     (Path : Texts.Text; Success : out Boolean; Reason : out Texts.Text)
   is
      Opened : Process.Outcome;
      Now    : Time;
   begin
      Process.Open (Path, Process.New_Also, Opened);
      Success := Opened >= 0;
      Process.Describe (-Integer'Min (0, Opened), Reason);
      if Success then
         File := Opened;
         Process.Empty (Opened);
         Ring.Reset;
         Ring.Get_Time (Now);
         First := Now;
         On := True;
      end if;
   end Open;

   procedure Append_Time
     (Line  : in out Texts.Text;
      Value : Time;
      Step  : Positive := 1;
      Width : Positive := 9)
   is
      Whole : Seconds_Count;
      Rest  : Time_Span;
   begin
      --  no division of the whole time: its result, an Integer, overflows
      --  after 24 days
      Split (Value, Whole, Rest);
      Texts.Append
        (Line,
         Natural
           (Seconds_Count'Max
              (0, Seconds_Count'Min (Whole, Seconds_Count (Natural'Last)))));
      Texts.Append (Line, ".");
      Texts.Append
        (Line,
         Integer'Max (0, Integer'Min (Rest / Nanoseconds (1), 999_999_999))
         / Step,
         Width);
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
         Texts.Append (Text, " " & Trim (Item.Label, Ada.Strings.Right));
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

   procedure Write_File (Reason : in out Texts.Text) is
      --  Reason is unchanged if all is written
      Into     : constant Process.Descriptor := File;
      Begun    : constant Time := First;
      Started  : constant Time := Clock;
      In_Time  : Boolean := True;
      Error    : Process.Error_Number := 0;
      Recorded : Event_Number;
      Number   : Event_Number;
      Item     : Event;
      Found    : Boolean;
      Text     : Texts.Text;
      Now      : Time;
   begin
      Process.Empty (Into);
      Texts.Set (Text, "# destijl trace, begun at ");
      Append_Time (Text, Begun);
      Texts.Append (Text, " of CLOCK_MONOTONIC" & ASCII.LF);
      for Who in Schedule.Task_Name loop
         Texts.Append (Text, "# task " & Schedule.Name_Of (Who) & " ");
         Texts.Append (Text, Schedule.Table (Who).Priority);
         Texts.Append (Text, (1 => ASCII.LF));
         Console.Write (Into, Texts.Image (Text), Error);
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
            Console.Write (Into, Texts.Image (Text), Error);
            Text.Length := 0;
            Now := Clock;
            In_Time := Now < Started + Schedule.Trace_Limit;
         end if;
      end loop;
      Console.Write (Into, Texts.Image (Text), Error);
      if Error > 0 then
         Process.Describe (Error, Reason);
      elsif not In_Time then
         Texts.Set (Reason, "it takes too long");
      end if;
   end Write_File;

   procedure Finish (Reason : out Texts.Text) is
      Recording : constant Boolean := On;
   begin
      Texts.Set (Reason, "");
      if Recording then
         On := False;
         --  not urgent any more, and it takes long
         Process.Give_Up_Priority;
         Write_File (Reason);
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
