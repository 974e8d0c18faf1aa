--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time; use Ada.Real_Time;
with Interfaces;    use Interfaces;
with Process;
with Trace.Calls;   use Trace.Calls;
with Trace.Ring;    use Trace.Ring;

package body Trace with
  SPARK_Mode,
  Refined_State =>
    (Recorder =>
       (On, File, First, Trace.Calls.System_State, Trace.Ring.Memory))
is

   On    : Boolean := False
     with Atomic, Async_Readers, Async_Writers;
   File  : Descriptor := None
     with Atomic, Async_Readers, Async_Writers;
   First : Unsigned_64 := 0
     with Atomic, Async_Readers, Async_Writers;
   --  When the recording began

   No_Label : constant Label_Text := (others => ' ');

   Longest : constant := 80;
   --  No line is longer, and Line_Of makes two at most

   function To_Natural (Value : Unsigned_64) return Natural is
     (if Value < 2 ** 31 then Natural (Value) else Natural'Last);

   procedure Open_Seekable
     (Path  : Texts.Text;
      Flags : Open_Flags;
      File  : out Descriptor;
      Error : out Error_Number)
   with
     Global => (In_Out => Calls.System_State),
     Post   => (File = None) = (Error > 0)
   is
      Opened : Outcome;
      Sought : Outcome;
   begin
      File := None;
      Error := 0;
      Calls.Open (Path, Flags, Opened);
      if Opened < 0 then
         Error := -Opened;
      else
         Calls.Seek_Start (Opened, Sought);
         if Sought < 0 then
            Error := -Sought;
            Calls.Close (Opened);
         else
            File := Opened;
         end if;
      end if;
   end Open_Seekable;

   procedure Set_Reason (Reason : out Texts.Text; Error : Error_Number) is
      --  The error message for Error, "" for 0
   begin
      if Error = 0 then
         Texts.Set (Reason, "");
      else
         Process.Describe (Error, Reason);
      end if;
   end Set_Reason;

   procedure Put
     (Kind   : Event_Kind;
      Who    : Task_Name;
      Number : Unsigned_64 := 0;
      Label  : Label_Text := No_Label)
   is
      --  Records an event with the current time, if recording
      Recording : constant Boolean := On;
      Now       : Unsigned_64;
   begin
      if Recording then
         Calls.Get_Time (Now);
         Ring.Put ((Now, Number, Who, Kind, Label));
      end if;
   end Put;

   procedure Try
     (Path : Texts.Text; Success : out Boolean; Reason : out Texts.Text)
   is
      Opened : Descriptor;
      Error  : Error_Number;
   begin
      Open_Seekable (Path, Calls.Existing, Opened, Error);
      if Error = Calls.Not_Found then
         Open_Seekable (Path, Calls.New_Only, Opened, Error);
         if Error = 0 then
            Calls.Remove (Path);
         end if;
      end if;
      if Error = 0 then
         Calls.Close (Opened);
      end if;
      Success := Error = 0;
      Set_Reason (Reason, Error);
   end Try;

   procedure Open
     (Path : Texts.Text; Success : out Boolean; Reason : out Texts.Text)
   is
      Opened : Descriptor;
      Error  : Error_Number;
      Now    : Unsigned_64;
   begin
      Open_Seekable (Path, Calls.New_Also, Opened, Error);
      Success := Error = 0;
      Set_Reason (Reason, Error);
      if Success then
         File := Opened;
         Calls.Empty (Opened);
         Ring.Reset;
         Calls.Ignore_Size_Signal;
         Calls.Get_Time (Now);
         First := Now;
         On := True;
      end if;
   end Open;

   procedure Write
     (Into : Descriptor; Text : Texts.Text; Error : in out Error_Number)
   with Global => (In_Out => Calls.System_State)
   is
      --  No effect after an Error
      Done   : Natural := 0;
      Result : Outcome;
   begin
      while Error = 0 and then Done < Text.Length loop
         pragma Loop_Invariant (Done < Text.Length);
         pragma Loop_Variant (Increases => Done);
         Calls.Write (Into, Text.Data (Done + 1 .. Text.Length), Result);
         if Result > 0 then
            Done := Done + Result;
         else
            Error := (if Result < 0 then -Result else Calls.Io_Failure);
         end if;
      end loop;
   end Write;

   procedure Append_Time (Line : in out Texts.Text; Value : Unsigned_64) is
      --  Value, in nanoseconds, as seconds
      Fraction : Texts.Text;
   begin
      Texts.Append (Line, To_Natural (Value / 1_000_000_000));
      Texts.Append
        (Fraction, 1_000_000_000 + Natural (Value mod 1_000_000_000));
      Fraction.Data (1) := '.';  --  for the 1, which has kept the zeros
      Texts.Append (Line, Texts.Image (Fraction));
   end Append_Time;

   procedure Append_Event
     (Text : in out Texts.Text; Begun : Unsigned_64; Item : Event)
   is
      --  The lines of the file for Item, with the time since Begun
      procedure Append_Line (What : String; At_Time, Number : Unsigned_64)
      with Pre => What'Length <= 9;

      procedure Append_Line (What : String; At_Time, Number : Unsigned_64) is
      begin
         Append_Time (Text, (if At_Time > Begun then At_Time - Begun else 0));
         Texts.Append (Text, " " & Schedule.Name_Of (Item.Who) & " " & What);
         if Item.Label /= No_Label then
            Texts.Append (Text, " ");
            for C of Item.Label loop
               exit when C = ' ';
               Texts.Append (Text, (1 => C));
            end loop;
         end if;
         if Number > 0 then
            Texts.Append (Text, " #");
            Texts.Append (Text, To_Natural (Number));
         end if;
         Texts.Append (Text, (1 => ASCII.LF));
      end Append_Line;

   begin
      if Item.Kind = Take_Up then
         Append_Line ("release", Item.At_Time, 0);
      elsif Item.Kind = Start_Due then
         Append_Line ("due", Item.Number, 0);
      end if;
      Append_Line
        ((case Item.Kind is
             when Release                     => "release",
             when Due                         => "due",
             when Start | Take_Up | Start_Due => "start",
             when Done                        => "done",
             when Wait                        => "wait",
             when Resume                      => "resume",
             when Idle                        => "idle",
             when Received                    => "in",
             when Sent                        => "out",
             when Ordered                     => "robot"),
         Item.At_Time,
         (if Item.Kind = Start_Due then 0 else Item.Number));
   end Append_Event;

   procedure Write_File
     (Into    : Descriptor;
      Limit   : Time;
      In_Time : out Boolean;
      Error   : out Error_Number)
   is
      --  Until Limit
      Begun    : constant Unsigned_64 := First;
      Recorded : Event_Number;
      Number   : Event_Number;
      Item     : Event;
      Found    : Boolean;
      Text     : Texts.Text;
      Now      : Time;
   begin
      In_Time := True;
      Error := 0;
      Calls.Empty (Into);
      Texts.Set (Text, "# destijl trace, begun at ");
      Append_Time (Text, Begun);
      Texts.Append (Text, " of CLOCK_MONOTONIC" & ASCII.LF);
      for Who in Task_Name loop
         Texts.Append (Text, "# task " & Schedule.Name_Of (Who) & " ");
         Texts.Append (Text, Schedule.Table (Who).Priority);
         Texts.Append (Text, (1 => ASCII.LF));
         Write (Into, Text, Error);
         Text.Length := 0;
      end loop;
      Ring.Get_Count (Recorded);
      Texts.Append (Text, "# recorded ");
      Texts.Append (Text, To_Natural (Recorded));
      Texts.Append (Text, (1 => ASCII.LF));
      Number := (if Recorded > Capacity then Recorded - Capacity else 0);
      while Number < Recorded and then In_Time and then Error = 0 loop
         pragma Loop_Variant (Increases => Number);
         Ring.Get (Number, Item, Found);
         if Found then
            Append_Event (Text, Begun, Item);
         end if;
         Number := Number + 1;
         if Text.Length > Texts.Max_Length - 2 * Longest then
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
      Limit     : constant Time := Now + Schedule.Trace_Limit;
      Recording : constant Boolean := On;
      Into      : constant Descriptor := File;
      Error     : Error_Number;
   begin
      Whole := True;
      Texts.Set (Reason, "");
      if Recording then
         On := False;
         --  not urgent any more, and it takes long
         Calls.Give_Up_Priority;
         Write_File (Into, Limit, Whole, Error);
         if Error > 0 then
            Whole := False;
            Set_Reason (Reason, Error);
         elsif not Whole then
            Texts.Set (Reason, "it takes too long");
         end if;
      end if;
   end Finish;

   function To_Nanoseconds (Due : Time) return Unsigned_64 is
      --  From the epoch of CLOCK_MONOTONIC, which is Ada's clock, too. 0 for
      --  times before, such as Time_First: immediate
      Seconds : Seconds_Count;
      Rest    : Time_Span;
   begin
      Split (Due, Seconds, Rest);
      return
        (if Seconds < 0 then 0
         else Unsigned_64 (Seconds) * 1_000_000_000
           + Unsigned_64 (Integer'Max (0, Rest / Nanoseconds (1))));
   end To_Nanoseconds;

   procedure Release (Who : Task_Name; Number : Orders.Ticket := 0) is
   begin
      Put (Release, Who, Unsigned_64 (Number));
   end Release;

   procedure Release (Who : Task_Name; Due : Time) is
      Recording : constant Boolean := On;
   begin
      if Recording then
         Ring.Put ((To_Nanoseconds (Due), 0, Who, Ring.Due, No_Label));
      end if;
   end Release;

   procedure Start (Who : Task_Name; Number : Orders.Ticket := 0) is
   begin
      Put (Start, Who, Unsigned_64 (Number));
   end Start;

   procedure Take_Up (Who : Task_Name) is
   begin
      Put (Take_Up, Who);
   end Take_Up;

   procedure Start (Who : Task_Name; Due : Time) is
   begin
      Put (Start_Due, Who, To_Nanoseconds (Due));
   end Start;

   procedure Done (Who : Task_Name) is
   begin
      Put (Done, Who);
   end Done;

   procedure Wait (Who : Task_Name; What : Wait_Kind) is
   begin
      Put (Wait, Who,
           Label => (case What is
                        when Line   => "line  ",
                        when Answer => "answer",
                        when Gap    => "gap   ",
                        when Camera => "camera",
                        when Room   => "room  ",
                        when Tasks  => "tasks "));
   end Wait;

   procedure Resume (Who : Task_Name) is
   begin
      Put (Resume, Who);
   end Resume;

   procedure Resume (Who : Task_Name; Due : Time) is
   begin
      Release (Who, Due);
      Put (Resume, Who);
   end Resume;

   procedure Idle (Who : Task_Name) is
   begin
      Put (Idle, Who);
   end Idle;

   procedure Received
     (Name : Commands.Command_Name; Number : Orders.Ticket) is
   begin
      Put (Received, Schedule.Th_Receive_From_Mon, Unsigned_64 (Number),
           Commands.Table (Name).Label & "  ");
   end Received;

   procedure Sent (Label : Commands.Label_Text) is
   begin
      Put (Sent, Schedule.Th_Send_To_Mon, Label => Label & "  ");
   end Sent;

   procedure Ordered (Who : Task_Name; Letter : Character) is
   begin
      Put (Ordered, Who, Label => Letter & "     ");
   end Ordered;

end Trace;
