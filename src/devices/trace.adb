--  SPDX-License-Identifier: GPL-3.0-or-later
--  The trace (--trace): what every task did and when. While the tasks work,
--  the events go through memory to the far end of the file; at the end they
--  become its text. Without it each call tests one flag.

with Ada.Real_Time;           use Ada.Real_Time;
with Ada.Unchecked_Conversion;
with GNAT.OS_Lib;
with Interfaces;              use Interfaces;
with Interfaces.C;            use Interfaces.C;
with Linux;                   use Linux;
with System;                  use System;
with System.Storage_Elements; use System.Storage_Elements;
with Trace_Json;
with Trace_Rings;

package body Trace with
  SPARK_Mode    => Off,
  Refined_State =>
    (Recorder =>
       (On, Storing, Ring, First, File, Emptied, Stored, Store_Error,
        Store_Due, Batch_At, Batch_First, Chunk_At, Chunk_Last, Written))
is

   use type Monitor_Protocol.Message_Kind;

   On      : Boolean := False with Atomic;
   Storing : Boolean := False with Atomic;  --  Store is at work
   Ring    : Trace_Rings.Ring;
   First   : Unsigned_64 := 0;  --  when the recording began
   File    : int := -1;

   --  The far end of the file: a round of Capacity places

   Store_At : constant := Capacity * (Texts.Max_Length + 32);
   --  The text never gets there, and nothing is in between

   type Stored_Event is record
      Mark : Unsigned_64 := 0;      --  its number and 1 more, 0: none
      Item : Trace_Json.Event;
   end record
   with Size => 32 * 8;

   Stored_Bytes : constant := 32;
   Batch_Length : constant := 512;

   type Batch is array (Unsigned_64 range 0 .. Batch_Length - 1)
     of Stored_Event
   with Component_Size => Stored_Bytes * 8;

   Emptied     : Boolean := False;
   --  Whether the file's former contents are gone. The first Store sees to
   --  it: it can take longer than all the rest of Open

   Stored      : Unsigned_64 := 0;  --  events below this are in the file
   Store_Error : Integer := 0;      --  why no more are, 0: they are
   Store_Due   : int := -1;         --  an eventfd: it is time to store
   Quarter     : constant := In_Memory / 4;
   Batch_At    : System.Address := System.Null_Address;
   Batch_First : Unsigned_64 := Unsigned_64'Last;
   --  What goes to the file's end, or has come from there: in Finish it
   --  begins with event Batch_First, if that is an event

   subtype Chunk_Text is String (1 .. 8_192);
   Chunk_At   : System.Address := System.Null_Address;
   Chunk_Last : Natural := 0;
   Written    : Natural := 0;
   --  What is to be written next of the text, and the bytes before

   Ring_Bytes  : constant := In_Memory * Trace_Rings.Slot_Bytes;
   Batch_Bytes : constant := Batch_Length * Stored_Bytes;

   Both_Ways   : constant int := 8#2004402#;
   --  O_RDWR, O_CLOEXEC, O_NONBLOCK, O_NOCTTY
   Or_Create   : constant int := 8#100#;   --  O_CREAT
   Or_New      : constant int := 8#300#;   --  O_CREAT, O_EXCL
   File_Mode   : constant unsigned := 8#644#;
   No_Entry    : constant := 2;            --  ENOENT

   Read_Write  : constant int := 3;        --  PROT_READ, PROT_WRITE
   All_Present : constant int := 16#8022#;
   --  MAP_PRIVATE, MAP_ANONYMOUS, MAP_POPULATE: every page is there at once

   Monotonic   : constant int := 1;        --  CLOCK_MONOTONIC
   Time_Shared : constant int := 0;        --  SCHED_OTHER

   function Open (Path : char_array; Flags : int; Mode : unsigned) return int
   with Import, Convention => C_Variadic_2, External_Name => "open";

   function Open_Places
     (Path : char_array; Flags : int; Mode : unsigned) return int;
   --  The same for a file with places; else -1, as for any other error

   function Unlink (Path : char_array) return int
   with Import, Convention => C, External_Name => "unlink";

   Event_Flags : constant int := 8#2004000#;  --  EFD_CLOEXEC, EFD_NONBLOCK

   function Event_Descriptor (Count : unsigned; Flags : int) return int
   with Import, Convention => C, External_Name => "eventfd";

   function Map
     (Where  : System.Address;
      Length : size_t;
      Access_Kind, Flags, Descriptor : int;
      Offset : long) return System.Address
   with Import, Convention => C, External_Name => "mmap";

   function Write_Place
     (Descriptor : int; Data : System.Address; Length : size_t; Place : long)
      return Ssize
   with Import, Convention => C, External_Name => "pwrite";

   function Read_Place
     (Descriptor : int; Data : System.Address; Length : size_t; Place : long)
      return Ssize
   with Import, Convention => C, External_Name => "pread";

   function Seek (Descriptor : int; Place : long; From : int) return long
   with Import, Convention => C, External_Name => "lseek";

   function Truncate (Descriptor : int; Length : long) return int
   with Import, Convention => C, External_Name => "ftruncate";

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
   --  GNAT's Duration is a count of nanoseconds in 64 bits; with another size
   --  this would not pass the validation build

   Beginning : constant Time := Time_Of (0, Time_Span_Zero);
   --  Of CLOCK_MONOTONIC, which is Ada's clock, too

   function Now return Unsigned_64;

   procedure Put (Item : Trace_Json.Event);

   procedure Put
     (Kind   : Trace_Json.Event_Kind;
      Who    : Task_Name;
      Number : Orders.Ticket := 0;
      Label  : Trace_Json.Label_Text := (others => ' '));
   --  An event of this moment

   function Count (Due : Time) return Unsigned_64 is
     (Nanoseconds (Duration'Max (0.0, To_Duration (Due - Beginning))));
   --  Due may be Time_First: at once

   function Place_Of (Number : Unsigned_64) return long is
     (Store_At + Stored_Bytes * long (Number mod Capacity));

   procedure Store_Batch (From : Unsigned_64; Length : Unsigned_64);
   --  Events From and on, Length of them, from the batch to the file

   procedure Fetch
     (Number : Unsigned_64;
      Item   : out Trace_Json.Event;
      Found  : out Boolean);
   --  From the file or the ring, once the recording has ended

   procedure Flush (Success : in out Boolean);

   procedure Write (Text : String; Success : in out Boolean);
   --  Without effect where Success is false already

   -----------
   -- Flush --
   -----------

   procedure Flush (Success : in out Boolean) is
      Chunk : Chunk_Text with Import, Address => Chunk_At;
      Next  : Positive := 1;
      Taken : Ssize;
   begin
      while Success and then Next <= Chunk_Last loop
         Taken := Linux.Write
           (File, Chunk (Next)'Address, size_t (Chunk_Last - Next + 1));
         if Taken > 0 then
            Next := Next + Positive (Taken);
            Written := Written + Positive (Taken);
         else
            Success := GNAT.OS_Lib.Errno = EINTR;
         end if;
      end loop;
      Chunk_Last := 0;
   end Flush;

   -----------
   -- Write --
   -----------

   procedure Write (Text : String; Success : in out Boolean) is
      Chunk : Chunk_Text with Import, Address => Chunk_At;
   begin
      if Chunk_Last + Text'Length > Chunk'Last then
         Flush (Success);
      end if;
      Chunk (Chunk_Last + 1 .. Chunk_Last + Text'Length) := Text;
      Chunk_Last := Chunk_Last + Text'Length;
   end Write;

   ---------
   -- Now --
   ---------

   function Now return Unsigned_64 is
      Read    : Time_Spec := (0, 0);
      Ignored : constant int := Get_Time (Monotonic, Read'Address);
      pragma Unreferenced (Ignored);
   begin
      return Unsigned_64 (Read.Seconds) * 1_000_000_000
        + Unsigned_64 (Read.Nanoseconds);
   end Now;

   ---------
   -- Put --
   ---------

   procedure Put (Item : Trace_Json.Event) is
      Number : Unsigned_64;
   begin
      Trace_Rings.Put (Ring, Item, Number);
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

   -----------------
   -- Open_Places --
   -----------------

   function Open_Places
     (Path : char_array; Flags : int; Mode : unsigned) return int
   is
      Current : constant int := 1;  --  SEEK_CUR
      Found   : constant int := Open (Path, Flags, Mode);
   begin
      if Found < 0 or else Seek (Found, 0, Current) >= 0 then
         return Found;
      end if;
      Linux.Close (Found);
      return -1;
   end Open_Places;

   ---------
   -- Try --
   ---------

   procedure Try
     (Path : Texts.Text; Success : out Boolean; Reason : out Texts.Text)
   is
      Name    : constant char_array := To_C (Texts.Image (Path));
      Found   : int;
      Ignored : int;
   begin
      Found := Open_Places (Name, Both_Ways, 0);
      if Found < 0 and then GNAT.OS_Lib.Errno = No_Entry then
         Found := Open_Places (Name, Both_Ways + Or_New, File_Mode);
         if Found >= 0 then
            Ignored := Unlink (Name);
         end if;
      end if;
      Success := Found >= 0;
      Texts.Set
        (Reason,
         (if Success then "" else Linux.Error_Text (GNAT.OS_Lib.Errno)));
      if Success then
         Linux.Close (Found);
      end if;
   end Try;

   ----------
   -- Open --
   ----------

   procedure Open
     (Path : Texts.Text; Success : out Boolean; Reason : out Texts.Text)
   is
      Memory  : System.Address := Not_Mapped;
      Ignored : int;
   begin
      File := Open_Places
        (To_C (Texts.Image (Path)), Both_Ways + Or_Create, File_Mode);
      if File >= 0 then
         Store_Due := Event_Descriptor (0, Event_Flags);
      end if;
      if Store_Due >= 0 then
         Memory := Map
           (System.Null_Address, Ring_Bytes + Batch_Bytes + Chunk_Text'Length,
            Read_Write, All_Present, -1, 0);
      end if;
      Success := Memory /= Not_Mapped;
      Texts.Set
        (Reason,
         (if Success then "" else Linux.Error_Text (GNAT.OS_Lib.Errno)));
      if Success then
         Trace_Rings.Set_Up (Ring, Memory, In_Memory);
         Batch_At := Memory + Ring_Bytes;
         Chunk_At := Batch_At + Batch_Bytes;
         Ignored := Set_Mask (0, File_Too_Large'Address, System.Null_Address);
         First := Now;
         On := True;
      end if;
   end Open;

   -----------------
   -- Store_Batch --
   -----------------

   procedure Store_Batch (From : Unsigned_64; Length : Unsigned_64) is
      Bytes : constant Storage_Count := Storage_Count (Length) * Stored_Bytes;
      Done  : Storage_Count := 0;
      Taken : Ssize;
   begin
      while Store_Error = 0 and then Done < Bytes loop
         Taken := Write_Place
           (File, Batch_At + Done, size_t (Bytes - Done),
            Place_Of (From) + long (Done));
         if Taken > 0 then
            Done := Done + Storage_Count (Taken);
         elsif GNAT.OS_Lib.Errno /= EINTR then
            Store_Error := GNAT.OS_Lib.Errno;
         end if;
      end loop;
      if Store_Error = 0 then
         Stored := From + Length;
      end if;
   end Store_Batch;

   -----------
   -- Store --
   -----------

   procedure Store is
      Next    : Batch with Import, Address => Batch_At;
      Last    : Unsigned_64;
      Number  : Unsigned_64;
      Length  : Unsigned_64;
      Found   : Boolean;
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
      if On and then Store_Error = 0 then
         if not Emptied then
            Ignored := Truncate (File, 0);
            Emptied := True;
         end if;
         Last := Trace_Rings.Count (Ring);
         if Last - Stored > In_Memory then
            Stored := Last - In_Memory;
         end if;
         loop
            Length := 0;
            loop
               Number := Stored + Length;
               exit when Number = Last
                 or else Length = Batch_Length
                 or else (Length > 0 and then Number mod Capacity = 0);
               Trace_Rings.Get (Ring, Number, Next (Length).Item, Found);
               --  it may be being written; the next time it is there
               exit when not Found and then Last - Number <= In_Memory / 2;
               Next (Length).Mark := (if Found then Number + 1 else 0);
               Length := Length + 1;
            end loop;
            exit when Length = 0;
            Store_Batch (Stored, Length);
            exit when Store_Error /= 0;
         end loop;
      end if;
      Storing := False;
   end Store;

   ----------
   -- Wake --
   ----------

   procedure Wake is
      One     : constant Unsigned_64 := 1;
      Ignored : Ssize;
      pragma Unreferenced (Ignored);
   begin
      if Store_Due >= 0 then
         Ignored := Linux.Write (Store_Due, One'Address, One'Size / 8);
      end if;
   end Wake;

   -----------
   -- Fetch --
   -----------

   procedure Fetch
     (Number : Unsigned_64;
      Item   : out Trace_Json.Event;
      Found  : out Boolean)
   is
      Read    : Batch with Import, Address => Batch_At;
      Place   : constant Unsigned_64 := Number mod Batch_Length;
      Ignored : Ssize;
   begin
      if Number >= Stored then
         Trace_Rings.Get (Ring, Number, Item, Found);
      else
         if Number - Place /= Batch_First then
            Batch_First := Number - Place;
            Ignored := Read_Place
              (File, Batch_At, Batch_Bytes, Place_Of (Batch_First));
            --  what it does not read, has another mark
         end if;
         Item := Read (Place).Item;
         Found := Read (Place).Mark = Number + 1;
      end if;
   end Fetch;

   ------------
   -- Finish --
   ------------

   procedure Finish (Whole : out Boolean; Reason : out Texts.Text) is
      Lowest  : int := 0;
      Ignored : int;
      Limit   : constant Time := Clock + Schedule.Trace_Limit;
      Slices  : Trace_Json.Slices := (others => Trace_Json.None);
      Line    : Texts.Text;
      Item    : Trace_Json.Event;
      Found   : Boolean;
      Kept    : Unsigned_64 := 0;
      Last    : Unsigned_64;  --  events are numbered below this
      Oldest  : Unsigned_64;
      Next    : Unsigned_64;
      In_Time : Boolean := True;
   begin
      Whole := True;
      Texts.Set (Reason, "");
      if not On then
         return;
      end if;
      On := False;
      --  nobody waits for this any more, and it takes long
      Ignored := Set_Scheduler (0, Time_Shared, Lowest'Address);
      Ignored := Set_Mask (0, File_Too_Large'Address, System.Null_Address);
      while Storing and then In_Time loop
         delay until Clock + Schedule.Release_Poll;
         In_Time := Clock < Limit;
      end loop;
      if In_Time then
         Last := Trace_Rings.Count (Ring);
         Oldest := (if Last > Capacity then Last - Capacity else 0);
         for Number in Oldest + 1 .. Last loop
            Fetch (Number - 1, Item, Found);
            Kept := Kept + (if Found then 1 else 0);
         end loop;
         Trace_Json.Begin_Text (First, Last, Kept, Line);
         Write (Texts.Image (Line), Whole);
         for Who in Task_Name loop
            Trace_Json.Name_Task (Who, Line);
            Write (Texts.Image (Line), Whole);
         end loop;
         Next := Oldest;
         while Whole and then In_Time and then Next < Last loop
            Fetch (Next, Item, Found);
            if Found then
               Trace_Json.Put (Slices, First, Item, Line);
               Write (Texts.Image (Line), Whole);
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
            Write (Texts.Image (Line), Whole);
         end loop;
         Write (Trace_Json.End_Of_Text, Whole);
         Flush (Whole);
         if not Whole then
            Texts.Set (Reason, Linux.Error_Text (GNAT.OS_Lib.Errno));
         end if;
         Ignored := Truncate (File, long (Written));
      end if;
      if Whole and then not In_Time then
         Whole := False;
         Texts.Set (Reason, "it takes too long");
      elsif Whole and then Store_Error /= 0 then
         Whole := False;
         Texts.Set (Reason, Linux.Error_Text (Store_Error));
      end if;
   end Finish;

   -------------
   -- Release --
   -------------

   procedure Release (Who : Task_Name; Number : Orders.Ticket := 0) is
   begin
      if On then
         Put (Trace_Json.Release, Who, Number);
      end if;
   end Release;

   -----------
   -- Start --
   -----------

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

   -------------
   -- Take_Up --
   -------------

   procedure Take_Up (Who : Task_Name) is
   begin
      if On then
         Put (Trace_Json.Take_Up, Who);
      end if;
   end Take_Up;

   ----------
   -- Done --
   ----------

   procedure Done (Who : Task_Name) is
   begin
      if On then
         Put (Trace_Json.Done, Who);
      end if;
   end Done;

   ----------
   -- Wait --
   ----------

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

   ------------
   -- Resume --
   ------------

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

   ----------
   -- Idle --
   ----------

   procedure Idle (Who : Task_Name) is
   begin
      if On then
         Put (Trace_Json.Idle, Who);
      end if;
   end Idle;

   --------------
   -- Received --
   --------------

   procedure Received
     (Kind : Monitor_Protocol.Message_Kind; Number : Orders.Ticket) is
   begin
      if On then
         Put (Trace_Json.Received, Schedule.Th_Receive_From_Mon, Number,
              (if Kind = Monitor_Protocol.Malformed then "none  "
               else Monitor_Protocol.Label (Kind) & "  "));
      end if;
   end Received;

   ----------
   -- Sent --
   ----------

   procedure Sent (Label : Monitor_Protocol.Label_Text) is
   begin
      if On then
         Put (Trace_Json.Sent, Schedule.Th_Send_To_Mon,
              Label => Label & "  ");
      end if;
   end Sent;

   -------------
   -- Ordered --
   -------------

   procedure Ordered (Who : Task_Name; Kind : Robot_Protocol.Command_Kind) is
   begin
      if On then
         Put (Trace_Json.Ordered, Who,
              Label => (1      => Robot_Protocol.Letter (Kind),
                        others => ' '));
      end if;
   end Ordered;

end Trace;
