--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time; use Ada.Real_Time;
with Error_Texts;
with Interfaces;    use Interfaces;
with Trace.Calls;   use Trace.Calls;
with Trace.Ring_Memory;
with Trace.Rings;
with Trace.Storage;
with Trace_Json;

package body Trace with
  SPARK_Mode,
  Refined_State =>
    (Recorder =>
       (On, Storing, File, Store_Due, First, Saved, Save_Error,
        Trace.Calls.System_State, Trace.Ring_Memory.Memory))
is

   use type Monitor.Protocol.Message_Kind;

   subtype Event_Number is Trace_Layout.Event_Number;

   --  Each is atomic: Store and Finish are called by different tasks. After
   --  Open only Store changes the last two, and Finish reads them when Store
   --  is not at work

   On         : Boolean := False
     with Atomic, Async_Readers, Async_Writers;
   Storing    : Boolean := False
     with Atomic, Async_Readers, Async_Writers;
   --  Store is at work
   File       : Descriptor := None
     with Atomic, Async_Readers, Async_Writers;
   Store_Due  : Descriptor := None
     with Atomic, Async_Readers, Async_Writers;
   --  An event counter: it is time to store
   First      : Unsigned_64 := 0
     with Atomic, Async_Readers, Async_Writers;
   --  When the recording began
   Saved      : Event_Number := 0
     with Atomic, Async_Readers, Async_Writers;
   --  Events below this are in the file, except skipped ones
   Save_Error : Error_Number := 0
     with Atomic, Async_Readers, Async_Writers;
   --  The error that stopped the saving of events

   Quarter  : constant := In_Memory / 4;
   No_Label : constant Trace_Json.Label_Text := "      ";

   function To_Nanoseconds (Due : Time) return Unsigned_64;
   --  From the epoch of CLOCK_MONOTONIC, which is Ada's clock, too. 0 for
   --  times before, such as Time_First: immediate

   procedure Set_Reason (Reason : out Texts.Text; Error : Error_Number);
   --  The error message for Error, "" for 0

   procedure Put (Item : Trace_Json.Event);

   procedure Put
     (Kind   : Trace_Json.Event_Kind;
      Who    : Task_Name;
      Number : Unsigned_64 := 0;
      Label  : Trace_Json.Label_Text := No_Label);
   --  Records an event with the current time

   procedure Fill
     (Next    : Event_Number;
      Last    : Event_Number;
      Data    : in out Trace_Layout.Batch;
      Length  : in out Trace_Layout.Batch_Count;
      Stopped : out Boolean)
   with
     Pre  => Next < Last and then Unsigned_64 (Length) <= Last - Next,
     Post => Length <= Length'Old
       and then (if not Stopped then Length = Length'Old);
   --  The events from Next on, Length of them at most, from the ring into
   --  Data. Stopped by an event that may still be being written

   procedure Save (Into : Descriptor);
   --  Saves what is in the ring

   procedure Fetch
     (Reader    : in out Trace.Storage.Batch_Reader;
      From      : Descriptor;
      Not_Saved : Event_Number;
      Number    : Event_Number;
      Item      : out Trace_Json.Event;
      Found     : out Boolean);
   --  From the file or, from Not_Saved on, from the ring, after the end of the
   --  recording

   procedure Wait_Stored (Limit : Time; In_Time : out Boolean);
   --  Waits until Store is not at work, Limit at most

   procedure Write_Text
     (Limit : Time; In_Time : out Boolean; Error : out Error_Number);
   --  Writes the text of the events that are kept, until Limit

   function To_Nanoseconds (Due : Time) return Unsigned_64 is
      Seconds : Seconds_Count;
      Rest    : Time_Span;
   begin
      Split (Due, Seconds, Rest);
      return
        (if Seconds < 0 then 0
         else Unsigned_64 (Seconds) * 1_000_000_000
           + Unsigned_64 (Integer'Max (0, Rest / Nanoseconds (1))));
   end To_Nanoseconds;

   procedure Set_Reason (Reason : out Texts.Text; Error : Error_Number) is
   begin
      if Error = 0 then
         Texts.Set (Reason, "");
      else
         Error_Texts.Describe (Error, Reason);
      end if;
   end Set_Reason;

   procedure Put (Item : Trace_Json.Event) is
      Number : Event_Number;
   begin
      Trace.Rings.Put (Item, Number);
      if Number mod Quarter = 0 then
         Wake;
      end if;
   end Put;

   procedure Put
     (Kind   : Trace_Json.Event_Kind;
      Who    : Task_Name;
      Number : Unsigned_64 := 0;
      Label  : Trace_Json.Label_Text := No_Label)
   is
      Now : Unsigned_64;
   begin
      Calls.Get_Time (Now);
      Put ((Now, Number, Who, Kind, Label));
   end Put;

   procedure Try
     (Path : Texts.Text; Success : out Boolean; Reason : out Texts.Text)
   is
      Error : Error_Number;
   begin
      Trace.Storage.Try (Path, Error);
      Success := Error = 0;
      Set_Reason (Reason, Error);
   end Try;

   procedure Open
     (Path : Texts.Text; Success : out Boolean; Reason : out Texts.Text)
   is
      Opened  : Descriptor;
      Counter : Outcome;
      Error   : Error_Number;
      Now     : Unsigned_64;
   begin
      Trace.Storage.Open (Path, Opened, Error);
      if Error = 0 then
         Calls.Make_Counter (Counter);
         if Counter < 0 then
            Error := -Counter;
         else
            File := Opened;
            Store_Due := Counter;
            Trace.Ring_Memory.Reset;
            Calls.Ignore_Size_Signal;
            Calls.Get_Time (Now);
            First := Now;
            On := True;
         end if;
      end if;
      Success := Error = 0;
      Set_Reason (Reason, Error);
   end Open;

   procedure Fill
     (Next    : Event_Number;
      Last    : Event_Number;
      Data    : in out Trace_Layout.Batch;
      Length  : in out Trace_Layout.Batch_Count;
      Stopped : out Boolean)
   is
      Item   : Trace_Json.Event;
      Found  : Boolean;
      Number : Event_Number;
   begin
      Stopped := False;
      for Index in 0 .. Length - 1 loop
         pragma Loop_Invariant
           (Length = Length'Loop_Entry and then not Stopped);
         Number := Next + Unsigned_64 (Index);
         Trace.Rings.Get (Number, Item, Found);
         if Found then
            Data (Index) := Trace_Layout.To_Saved (Number, Item);
         elsif Trace_Layout.May_Come (Number, Last) then
            --  retry at the next call of Store
            Stopped := True;
            Length := Index;
            exit;
         else
            Data (Index) := Trace_Layout.No_Event;
         end if;
      end loop;
   end Fill;

   procedure Save (Into : Descriptor) is
      Data    : Trace_Layout.Batch := (others => Trace_Layout.No_Event);
      Next    : Event_Number := Saved;
      Last    : Event_Number;  --  upper bound of the event numbers, exclusive
      Length  : Trace_Layout.Batch_Count;
      Stopped : Boolean;
      Error   : Error_Number;
   begin
      if Next = 0 then
         --  its former contents. May take longer than Open
         Calls.Truncate (Into, 0);
      end if;
      Trace.Rings.Get_Count (Last);
      Next := Trace_Layout.First_To_Save (Next, Last);
      Saved := Next;
      loop
         pragma Loop_Variant (Increases => Next);
         Length := Trace_Layout.Run_Length (Next, Last);
         exit when Length = 0;
         Fill (Next, Last, Data, Length, Stopped);
         pragma Assert (Unsigned_64 (Length) <= Last - Next);
         Trace.Storage.Save
           (Into, Data, Length, Trace_Layout.Place_Of (Next), Error);
         Save_Error := Error;
         exit when Error > 0;
         Next := Next + Unsigned_64 (Length);
         Saved := Next;
         exit when Stopped;
      end loop;
   end Save;

   procedure Store is
      Counter   : constant Descriptor := Store_Due;
      Into      : constant Descriptor := File;
      Recording : Boolean;
      Error     : Error_Number;
   begin
      Calls.Wait
        (Counter, Natural'Max (0, Schedule.Store_Limit / Milliseconds (1)));
      Storing := True;
      Recording := On;
      Error := Save_Error;
      if Recording and then Error = 0 then
         Save (Into);
      end if;
      Storing := False;
   end Store;

   procedure Wake is
      Counter : constant Descriptor := Store_Due;
   begin
      if Counter /= None then
         Calls.Add (Counter);
      end if;
   end Wake;

   procedure Fetch
     (Reader    : in out Trace.Storage.Batch_Reader;
      From      : Descriptor;
      Not_Saved : Event_Number;
      Number    : Event_Number;
      Item      : out Trace_Json.Event;
      Found     : out Boolean) is
   begin
      if Number >= Not_Saved then
         Trace.Rings.Get (Number, Item, Found);
      else
         Trace.Storage.Get (Reader, From, Number, Item, Found);
      end if;
   end Fetch;

   procedure Wait_Stored (Limit : Time; In_Time : out Boolean) is
      Now  : Time;
      Busy : Boolean;
   begin
      --  the clock ends it, but GNATprove does not reason about time
      for Turn in 1 .. 1_000 loop
         Busy := Storing;
         Now := Clock;
         In_Time := Now < Limit;
         exit when not Busy or else not In_Time;
         delay until Now + Schedule.Release_Poll;
      end loop;
      In_Time := not Busy;
   end Wait_Stored;

   procedure Write_Text
     (Limit : Time; In_Time : out Boolean; Error : out Error_Number)
   is
      Tasks     : constant := Task_Name'Pos (Task_Name'Last) + 1;
      Into      : constant Descriptor := File;
      Not_Saved : constant Event_Number := Saved;
      Begun     : constant Unsigned_64 := First;
      Reader    : Trace.Storage.Batch_Reader;
      Writer    : Trace.Storage.Writer;
      Slices    : Trace_Json.Slices := (others => Trace_Json.None);
      Line      : Texts.Text;
      Item      : Trace_Json.Event := (others => <>);
      Found     : Boolean;
      Kept      : Unsigned_64 := 0;
      Last      : Event_Number;  --  upper bound of the numbers, exclusive
      Oldest    : Event_Number;
      Count     : Natural;
      Now       : Time;
   begin
      Trace.Rings.Get_Count (Last);
      Oldest := Trace_Layout.Oldest_Kept (Last);
      Count := Natural (Last - Oldest);
      for Past in 0 .. Count - 1 loop
         Fetch
           (Reader, Into, Not_Saved, Oldest + Unsigned_64 (Past), Item, Found);
         Kept := Kept + (if Found then 1 else 0);
      end loop;
      Trace_Json.Begin_Text (Begun, Last, Kept, Line);
      Trace.Storage.Put (Writer, Into, Line);
      for Who in Task_Name loop
         pragma Loop_Invariant
           (Trace.Storage.Size (Writer) <=
              (1 + Task_Name'Pos (Who)) * Texts.Max_Length);
         Trace_Json.Name_Task (Who, Line);
         Trace.Storage.Put (Writer, Into, Line);
      end loop;
      In_Time := True;
      for Past in 0 .. Count - 1 loop
         pragma Loop_Invariant
           (Trace.Storage.Size (Writer) <=
              (1 + Tasks + Past) * Texts.Max_Length);
         Fetch
           (Reader, Into, Not_Saved, Oldest + Unsigned_64 (Past), Item, Found);
         if Found then
            Trace_Json.Put (Slices, Begun, Item, Line);
            Trace.Storage.Put (Writer, Into, Line);
         end if;
         if Past mod 256 = 255 then
            Now := Clock;
            In_Time := Now < Limit;
         end if;
         exit when not In_Time or else Trace.Storage.Error_Of (Writer) > 0;
      end loop;
      if In_Time then
         Calls.Get_Time (Item.At_Time);
      end if;
      for Who in Task_Name loop
         pragma Loop_Invariant
           (Trace.Storage.Size (Writer) <=
              (1 + Tasks + Capacity + Task_Name'Pos (Who))
              * Texts.Max_Length);
         Item := (At_Time => Item.At_Time,
                  Who     => Who,
                  Kind    => Trace_Json.Done,
                  others  => <>);
         Trace_Json.Put (Slices, Begun, Item, Line);
         Trace.Storage.Put (Writer, Into, Line);
      end loop;
      Texts.Set (Line, Trace_Json.End_Of_Text);
      Trace.Storage.Put (Writer, Into, Line);
      Trace.Storage.End_Text (Writer, Into);
      Error := Trace.Storage.Error_Of (Writer);
   end Write_Text;

   procedure Finish (Whole : out Boolean; Reason : out Texts.Text) is
      Now       : constant Time := Clock;
      Limit     : constant Time := Now + Schedule.Trace_Limit;
      Recording : constant Boolean := On;
      In_Time   : Boolean;
      Error     : Error_Number := 0;
   begin
      Whole := True;
      Texts.Set (Reason, "");
      if not Recording then
         return;
      end if;
      On := False;
      --  not urgent any more, and it takes long
      Calls.Give_Up_Priority;
      Wait_Stored (Limit, In_Time);
      if In_Time then
         Write_Text (Limit, In_Time, Error);
      end if;
      if Error = 0 and then not In_Time then
         Whole := False;
         Texts.Set (Reason, "it takes too long");
      else
         if Error = 0 then
            Error := Save_Error;
         end if;
         Whole := Error = 0;
         Set_Reason (Reason, Error);
      end if;
   end Finish;

   procedure Release (Who : Task_Name; Number : Orders.Ticket := 0) is
      Recording : constant Boolean := On;
   begin
      if Recording then
         Put (Trace_Json.Release, Who, Unsigned_64 (Number));
      end if;
   end Release;

   procedure Start (Who : Task_Name; Number : Orders.Ticket := 0) is
      Recording : constant Boolean := On;
   begin
      if Recording then
         Put (Trace_Json.Start, Who, Unsigned_64 (Number));
      end if;
   end Start;

   procedure Start (Who : Task_Name; Due : Time) is
      Recording : constant Boolean := On;
   begin
      if Recording then
         Put (Trace_Json.Start_Due, Who, To_Nanoseconds (Due));
      end if;
   end Start;

   procedure Take_Up (Who : Task_Name) is
      Recording : constant Boolean := On;
   begin
      if Recording then
         Put (Trace_Json.Take_Up, Who);
      end if;
   end Take_Up;

   procedure Done (Who : Task_Name) is
      Recording : constant Boolean := On;
   begin
      if Recording then
         Put (Trace_Json.Done, Who);
      end if;
   end Done;

   procedure Wait (Who : Task_Name; What : Wait_Kind) is
      Recording : constant Boolean := On;
   begin
      if Recording then
         Put (Trace_Json.Wait, Who,
              Label => (case What is
                           when Line   => "line  ",
                           when Answer => "answer",
                           when Gap    => "gap   ",
                           when Camera => "camera",
                           when Room   => "room  ",
                           when Tasks  => "tasks "));
      end if;
   end Wait;

   procedure Resume (Who : Task_Name) is
      Recording : constant Boolean := On;
   begin
      if Recording then
         Put (Trace_Json.Resume, Who);
      end if;
   end Resume;

   procedure Resume (Who : Task_Name; Due : Time) is
      Recording : constant Boolean := On;
   begin
      if Recording then
         Put ((To_Nanoseconds (Due), 0, Who, Trace_Json.Due, No_Label));
         Put (Trace_Json.Resume, Who);
      end if;
   end Resume;

   procedure Idle (Who : Task_Name) is
      Recording : constant Boolean := On;
   begin
      if Recording then
         Put (Trace_Json.Idle, Who);
      end if;
   end Idle;

   procedure Received
     (Kind : Monitor.Protocol.Message_Kind; Number : Orders.Ticket)
   is
      Recording : constant Boolean := On;
   begin
      if Recording then
         Put (Trace_Json.Received, Schedule.Th_Receive_From_Mon,
              Unsigned_64 (Number),
              (if Kind = Monitor.Protocol.Malformed then "none  "
               else Monitor.Protocol.Label (Kind) & "  "));
      end if;
   end Received;

   procedure Sent (Label : Monitor.Protocol.Label_Text) is
      Recording : constant Boolean := On;
   begin
      if Recording then
         Put (Trace_Json.Sent, Schedule.Th_Send_To_Mon,
              Label => Label & "  ");
      end if;
   end Sent;

   procedure Ordered (Who : Task_Name; Kind : Robot.Protocol.Command_Kind) is
      Recording : constant Boolean := On;
   begin
      if Recording then
         Put (Trace_Json.Ordered, Who,
              Label => Robot.Protocol.Letter (Kind) & "     ");
      end if;
   end Ordered;

end Trace;
