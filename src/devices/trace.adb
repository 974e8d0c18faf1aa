--  SPDX-License-Identifier: GPL-3.0-or-later
--  The trace (--trace): what every task did and when, in memory while the
--  tasks work, in a file at the end. Without it each call tests one flag.

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
  Refined_State => (Recorder => (On, Ring, First, File, Chunk_At, Chunk_Last))
is

   use type Monitor_Protocol.Message_Kind;

   On    : Boolean := False with Atomic;
   Ring  : Trace_Rings.Ring;
   First : Unsigned_64 := 0;  --  when the recording began
   File  : int := -1;

   subtype Chunk_Text is String (1 .. 65_536);
   Chunk_At   : System.Address := System.Null_Address;
   Chunk_Last : Natural := 0;
   --  What is to be written next, behind the ring in memory

   Ring_Bytes  : constant := Capacity * Trace_Rings.Slot_Bytes;

   Write_Only  : constant int := 8#2004401#;
   --  O_WRONLY, O_CLOEXEC, O_NONBLOCK, O_NOCTTY
   Or_Empty    : constant int := 8#1100#;  --  O_CREAT, O_TRUNC
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

   function Unlink (Path : char_array) return int
   with Import, Convention => C, External_Name => "unlink";

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
   --  GNAT's Duration is a count of nanoseconds in 64 bits; with another size
   --  this would not pass the validation build

   Beginning : constant Time := Time_Of (0, Time_Span_Zero);
   --  Of CLOCK_MONOTONIC, which is Ada's clock, too

   function Now return Unsigned_64;

   procedure Put
     (Kind   : Trace_Json.Event_Kind;
      Who    : Task_Name;
      Number : Orders.Ticket := 0;
      Label  : Trace_Json.Label_Text := (others => ' '));
   --  An event of this moment

   function Count (Due : Time) return Unsigned_64 is
     (Nanoseconds (Duration'Max (0.0, To_Duration (Due - Beginning))));
   --  Due may be Time_First: at once

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

   procedure Put
     (Kind   : Trace_Json.Event_Kind;
      Who    : Task_Name;
      Number : Orders.Ticket := 0;
      Label  : Trace_Json.Label_Text := (others => ' ')) is
   begin
      Trace_Rings.Put
        (Ring, (Now, Unsigned_64 (Number), Who, Kind, Label));
   end Put;

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
      Found := Open (Name, Write_Only, 0);
      if Found < 0 and then GNAT.OS_Lib.Errno = No_Entry then
         Found := Open (Name, Write_Only + Or_New, File_Mode);
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
      Memory : System.Address := Not_Mapped;
   begin
      File := Open
        (To_C (Texts.Image (Path)), Write_Only + Or_Empty, File_Mode);
      if File >= 0 then
         Memory := Map
           (System.Null_Address, Ring_Bytes + Chunk_Text'Length,
            Read_Write, All_Present, -1, 0);
      end if;
      Success := Memory /= Not_Mapped;
      Texts.Set
        (Reason,
         (if Success then "" else Linux.Error_Text (GNAT.OS_Lib.Errno)));
      if Success then
         Trace_Rings.Set_Up (Ring, Memory, Capacity);
         Chunk_At := Memory + Ring_Bytes;
         First := Now;
         On := True;
      end if;
   end Open;

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
      Last    : Unsigned_64;  --  events are numbered below this
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
      Last := Trace_Rings.Count (Ring);
      Next := (if Last > Capacity then Last - Capacity else 0);
      Trace_Json.Begin_Text (First, Last, Last - Next, Line);
      Write (Texts.Image (Line), Whole);
      for Who in Task_Name loop
         Trace_Json.Name_Task (Who, Line);
         Write (Texts.Image (Line), Whole);
      end loop;
      while Whole and then In_Time and then Next < Last loop
         Trace_Rings.Get (Ring, Next, Item, Found);
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
      elsif not In_Time then
         Whole := False;
         Texts.Set (Reason, "it takes too long");
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
         Trace_Rings.Put
           (Ring, (Count (Due), 0, Who, Trace_Json.Due, (others => ' ')));
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
