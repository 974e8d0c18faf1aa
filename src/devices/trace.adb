--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time;           use Ada.Real_Time;
with Ada.Unchecked_Conversion;
with GNAT.OS_Lib;
with Interfaces;              use Interfaces;
with Interfaces.C;            use Interfaces.C;
with Linux;                   use Linux;
with System;                  use System;
with System.Storage_Elements; use System.Storage_Elements;
with Trace.Rings;
with Trace.Storage;
with Trace_Json;

package body Trace with
  SPARK_Mode    => Off,
  Refined_State =>
    (Recorder => (On, Storing, Ring, File, First, Store_Due))
is

   use type Monitor.Protocol.Message_Kind;

   On        : Boolean := False with Atomic;
   Storing   : Boolean := False with Atomic;  --  Store is at work
   Ring      : Trace.Rings.Ring;
   File      : Trace.Storage.File;
   First     : Unsigned_64 := 0;  --  when the recording began
   Store_Due : int := -1;         --  an eventfd: it is time to store
   Quarter   : constant := In_Memory / 4;

   Ring_Bytes  : constant := In_Memory * Trace.Rings.Slot_Bytes;
   Read_Write  : constant int := 3;        --  PROT_READ, PROT_WRITE
   All_Present : constant int := 16#8022#;
   --  MAP_PRIVATE, MAP_ANONYMOUS, MAP_POPULATE: all pages are prefaulted

   Monotonic   : constant int := 1;        --  CLOCK_MONOTONIC
   Time_Shared : constant int := 0;        --  SCHED_OTHER

   function Map
     (Where  : System.Address;
      Length : size_t;
      Access_Kind, Flags, Descriptor : int;
      Offset : long) return System.Address
   with Import, Convention => C, External_Name => "mmap";

   Not_Mapped : constant System.Address :=
     System'To_Address (System.Memory_Size - 1);  --  MAP_FAILED

   function Get_Time (Clock : int; Now : System.Address) return int
   with Import, Convention => C, External_Name => "clock_gettime";

   type Signal_Set is array (1 .. 16) of Unsigned_64 with Convention => C;

   File_Too_Large : constant Signal_Set := (1 => 2 ** 24, others => 0);
   --  SIGXFSZ, which would end the process

   function Set_Mask
     (How : int; Set : System.Address; Old : System.Address) return int
   with Import, Convention => C, External_Name => "pthread_sigmask";

   function Set_Scheduler
     (Thread : int; Policy : int; Priority : System.Address) return int
   with Import, Convention => C, External_Name => "sched_setscheduler";

   function Nanoseconds is
     new Ada.Unchecked_Conversion (Duration, Unsigned_64);
   --  GNAT's Duration counts nanoseconds in 64 bits; with another size the
   --  validation build fails

   Beginning : constant Time := Time_Of (0, Time_Span_Zero);
   --  The epoch of CLOCK_MONOTONIC, which is Ada's clock, too

   function Now return Unsigned_64;

   procedure Put (Item : Trace_Json.Event);

   procedure Put
     (Kind   : Trace_Json.Event_Kind;
      Who    : Task_Name;
      Number : Orders.Ticket := 0;
      Label  : Trace_Json.Label_Text := (others => ' '));
   --  Records an event with the current time

   function Count (Due : Time) return Unsigned_64 is
     (Nanoseconds (Duration'Max (0.0, To_Duration (Due - Beginning))));
   --  Due may be Time_First: immediate

   procedure Set_Reason (Reason : out Texts.Text; Number : Integer);
   --  The error message for Number, "" for 0

   procedure Fetch
     (Number : Unsigned_64;
      Item   : out Trace_Json.Event;
      Found  : out Boolean);
   --  From the file or the ring, after the end of the recording

   procedure Write (Line : Texts.Text);

   procedure Set_Reason (Reason : out Texts.Text; Number : Integer) is
   begin
      Texts.Set (Reason, (if Number = 0 then ""
                          else GNAT.OS_Lib.Errno_Message (Number)));
   end Set_Reason;

   function Now return Unsigned_64 is
      Read    : Time_Spec := (0, 0);
      Ignored : constant int := Get_Time (Monotonic, Read'Address);
      pragma Unreferenced (Ignored);
   begin
      return Unsigned_64 (Read.Seconds) * 1_000_000_000
        + Unsigned_64 (Read.Nanoseconds);
   end Now;

   procedure Put (Item : Trace_Json.Event) is
      Number : Unsigned_64;
   begin
      Trace.Rings.Put (Ring, Item, Number);
      if Number mod Quarter = 0 then
         Wake;
      end if;
   end Put;

   procedure Put
     (Kind   : Trace_Json.Event_Kind;
      Who    : Task_Name;
      Number : Orders.Ticket := 0;
      Label  : Trace_Json.Label_Text := (others => ' ')) is
   begin
      Put ((Now, Unsigned_64 (Number), Who, Kind, Label));
   end Put;

   procedure Try
     (Path : Texts.Text; Success : out Boolean; Reason : out Texts.Text)
   is
      Number : Integer;
   begin
      Trace.Storage.Try (Texts.Image (Path), Number);
      Success := Number = 0;
      Set_Reason (Reason, Number);
   end Try;

   procedure Open
     (Path : Texts.Text; Success : out Boolean; Reason : out Texts.Text)
   is
      Number  : Integer;
      Memory  : System.Address := Not_Mapped;
      Ignored : int;
   begin
      Trace.Storage.Open (File, Texts.Image (Path), Number);
      if Number = 0 then
         Store_Due := Event_Counter (0, Event_Non_Blocking);
         if Store_Due >= 0 then
            Memory := Map
              (System.Null_Address, Ring_Bytes + Trace.Storage.Buffer_Bytes,
               Read_Write, All_Present, -1, 0);
         end if;
         Number := (if Memory = Not_Mapped then GNAT.OS_Lib.Errno else 0);
      end if;
      Success := Number = 0;
      Set_Reason (Reason, Number);
      if Success then
         Trace.Rings.Set_Up (Ring, Memory, In_Memory);
         Trace.Storage.Set_Up (File, Memory + Ring_Bytes, Capacity);
         Ignored := Set_Mask (0, File_Too_Large'Address, System.Null_Address);
         First := Now;
         On := True;
      end if;
   end Open;

   procedure Store is
      Item    : Trace_Json.Event;
      Found   : Boolean;
      Last    : Unsigned_64;  --  upper bound of the event numbers, exclusive
      Waited  : Poll_Array := (1 => (Store_Due, Poll_In, 0));
      Calls   : Unsigned_64;
      Taken   : Ssize;
      Ignored : int;
      pragma Unreferenced (Taken, Ignored);
   begin
      Ignored := Poll
        (Waited'Address, 1,
         int (To_Duration (Schedule.Store_Limit * 1_000)));
      Taken := Read (Store_Due, Calls'Address, Calls'Size / 8);
      Storing := True;
      if On and then Trace.Storage.Save_Reason (File) = 0 then
         Trace.Storage.Empty (File);
         Last := Trace.Rings.Count (Ring);
         if Last - Trace.Storage.Next_Event (File) > In_Memory then
            Trace.Storage.Pass (File, Last - In_Memory);
         end if;
         for Number in Trace.Storage.Next_Event (File) + 1 .. Last loop
            Trace.Rings.Get (Ring, Number - 1, Item, Found);
            --  perhaps still being written: retry at the next call
            exit when not Found and then Last - Number < In_Memory / 2;
            Trace.Storage.Put (File, Item, Found);
         end loop;
         Trace.Storage.Save (File);
      end if;
      Storing := False;
   end Store;

   procedure Wake is
      One     : constant Unsigned_64 := 1;
      Ignored : Ssize;
      pragma Unreferenced (Ignored);
   begin
      if Store_Due >= 0 then
         Ignored := Linux.Write (Store_Due, One'Address, One'Size / 8);
      end if;
   end Wake;

   procedure Fetch
     (Number : Unsigned_64;
      Item   : out Trace_Json.Event;
      Found  : out Boolean) is
   begin
      if Number >= Trace.Storage.Next_Event (File) then
         Trace.Rings.Get (Ring, Number, Item, Found);
      else
         Trace.Storage.Get (File, Number, Item, Found);
      end if;
   end Fetch;

   procedure Write (Line : Texts.Text) is
   begin
      Trace.Storage.Write (File, Texts.Image (Line));
   end Write;

   procedure Finish (Whole : out Boolean; Reason : out Texts.Text) is
      Lowest  : int := 0;
      Ignored : int;
      Limit   : constant Time := Clock + Schedule.Trace_Limit;
      Slices  : Trace_Json.Slices := (others => Trace_Json.None);
      Line    : Texts.Text;
      Item    : Trace_Json.Event;
      Found   : Boolean;
      Kept    : Unsigned_64 := 0;
      Last    : Unsigned_64;  --  upper bound of the event numbers, exclusive
      Oldest  : Unsigned_64;
      Next    : Unsigned_64;
      In_Time : Boolean := True;
      Problem : Integer := 0;
   begin
      Whole := True;
      Texts.Set (Reason, "");
      if not On then
         return;
      end if;
      On := False;
      --  not urgent any more, and it takes long
      Ignored := Set_Scheduler (0, Time_Shared, Lowest'Address);
      Ignored := Set_Mask (0, File_Too_Large'Address, System.Null_Address);
      while Storing and then In_Time loop
         delay until Clock + Schedule.Release_Poll;
         In_Time := Clock < Limit;
      end loop;
      if In_Time then
         Last := Trace.Rings.Count (Ring);
         Oldest := (if Last > Capacity then Last - Capacity else 0);
         for Number in Oldest + 1 .. Last loop
            Fetch (Number - 1, Item, Found);
            Kept := Kept + (if Found then 1 else 0);
         end loop;
         Trace_Json.Begin_Text (First, Last, Kept, Line);
         Write (Line);
         for Who in Task_Name loop
            Trace_Json.Name_Task (Who, Line);
            Write (Line);
         end loop;
         Next := Oldest;
         while Trace.Storage.Write_Reason (File) = 0
           and then In_Time and then Next < Last
         loop
            Fetch (Next, Item, Found);
            if Found then
               Trace_Json.Put (Slices, First, Item, Line);
               Write (Line);
            end if;
            Next := Next + 1;
            In_Time := Next mod 256 > 0 or else Clock < Limit;
         end loop;
         for Who in Task_Name loop
            Item := (At_Time => (if In_Time then Now else Item.At_Time),
                     Who     => Who,
                     Kind    => Trace_Json.Done,
                     others  => <>);
            Trace_Json.Put (Slices, First, Item, Line);
            Write (Line);
         end loop;
         Trace.Storage.Write (File, Trace_Json.End_Of_Text);
         Trace.Storage.End_Text (File);
         Problem := Trace.Storage.Write_Reason (File);
      end if;
      if Problem = 0 and then not In_Time then
         Whole := False;
         Texts.Set (Reason, "it takes too long");
      else
         if Problem = 0 then
            Problem := Trace.Storage.Save_Reason (File);
         end if;
         Whole := Problem = 0;
         Set_Reason (Reason, Problem);
      end if;
   end Finish;

   procedure Release (Who : Task_Name; Number : Orders.Ticket := 0) is
   begin
      if On then
         Put (Trace_Json.Release, Who, Number);
      end if;
   end Release;

   procedure Start (Who : Task_Name; Number : Orders.Ticket := 0) is
   begin
      if On then
         Put (Trace_Json.Start, Who, Number);
      end if;
   end Start;

   procedure Start (Who : Task_Name; Due : Time) is
   begin
      if On then
         Put (Trace_Json.Start_Due, Who, Orders.Ticket (Count (Due)));
      end if;
   end Start;

   procedure Take_Up (Who : Task_Name) is
   begin
      if On then
         Put (Trace_Json.Take_Up, Who);
      end if;
   end Take_Up;

   procedure Done (Who : Task_Name) is
   begin
      if On then
         Put (Trace_Json.Done, Who);
      end if;
   end Done;

   procedure Wait (Who : Task_Name; What : Wait_Kind) is
   begin
      if On then
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
   begin
      if On then
         Put (Trace_Json.Resume, Who);
      end if;
   end Resume;

   procedure Resume (Who : Task_Name; Due : Time) is
   begin
      if On then
         Put ((Count (Due), 0, Who, Trace_Json.Due, (others => ' ')));
         Put (Trace_Json.Resume, Who);
      end if;
   end Resume;

   procedure Idle (Who : Task_Name) is
   begin
      if On then
         Put (Trace_Json.Idle, Who);
      end if;
   end Idle;

   procedure Received
     (Kind : Monitor.Protocol.Message_Kind; Number : Orders.Ticket) is
   begin
      if On then
         Put (Trace_Json.Received, Schedule.Th_Receive_From_Mon, Number,
              (if Kind = Monitor.Protocol.Malformed then "none  "
               else Monitor.Protocol.Label (Kind) & "  "));
      end if;
   end Received;

   procedure Sent (Label : Monitor.Protocol.Label_Text) is
   begin
      if On then
         Put (Trace_Json.Sent, Schedule.Th_Send_To_Mon,
              Label => Label & "  ");
      end if;
   end Sent;

   procedure Ordered (Who : Task_Name; Kind : Robot.Protocol.Command_Kind) is
   begin
      if On then
         Put (Trace_Json.Ordered, Who,
              Label => (1      => Robot.Protocol.Letter (Kind),
                        others => ' '));
      end if;
   end Ordered;

end Trace;
