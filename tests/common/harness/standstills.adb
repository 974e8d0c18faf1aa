--  SPDX-License-Identifier: GPL-3.0-or-later
--  Detects stalls of this machine's processors.

with Interfaces.C; use type Interfaces.C.int;
with System.Multiprocessors.Dispatching_Domains;

with Child_Processes; use Child_Processes;
with Libc;
with Own_Process;
with Polls;
with Process_Facts;
with Pseudo_Terminals;

package body Standstills is

   use System.Multiprocessors;

   Counted : constant Duration := 0.000_5;

   type Stall is record
      From, To : Instant := Never;
   end record;

   type Stall_Number is mod 8_192;

   type Stall_Array is array (Stall_Number) of Stall;

   protected type Stall_Record is
      procedure Begin_At (Time : Instant);
      --  What is under way since then, until Add
      procedure Add (Gap : Duration; Item : Stall);
      procedure Clear;
      function Longest return Duration;
      function Noted return Stall_Array;
   private
      Worst  : Duration := 0.0;
      Begun  : Instant := Never;
      Stalls : Stall_Array;
      Place  : Stall_Number := 0;
   end Stall_Record;

   Of_Processors, Of_Lines : Stall_Record;

   task type Watcher (Processor : CPU_Range; Turn : Positive);
   --  Of the line if the processor is 0

   type Watcher_Access is access Watcher;

   protected body Stall_Record is

      procedure Begin_At (Time : Instant) is
      begin
         Begun := Time;
      end Begin_At;

      procedure Add (Gap : Duration; Item : Stall) is
      begin
         Begun := Never;
         Worst := Duration'Max (Worst, Gap);
         if Gap >= Counted then
            Stalls (Place) := Item;
            Place := Place + 1;
         end if;
      end Add;

      procedure Clear is
      begin
         Worst := 0.0;
      end Clear;

      function Longest return Duration is
        (if Begun = Never then Worst else Duration'Max (Worst, Now - Begun));

      function Noted return Stall_Array is (Stalls);

   end Stall_Record;

   procedure Watch_Processor (Processor : CPU; Span : Duration) is
      Before : Instant;
      Time   : Instant;
   begin
      begin
         Dispatching_Domains.Set_CPU (Processor);
      exception
         when Dispatching_Domains.Dispatching_Domain_Error =>
            null;  --  it may not run there: it stays where it is
      end;
      loop
         Before := Now;
         delay Span;
         Time := Now;
         Of_Processors.Add (Time - Before - Span, (Before, Time));
      end loop;
   end Watch_Processor;

   procedure Watch_Line (Span : Duration) is
      Line   : Pseudo_Terminals.Line;
      Open   : Boolean;
      Byte   : aliased Character := 'x';
      Before : Instant;
      Time   : Instant;
      Unused : Interfaces.C.long;
   begin
      Pseudo_Terminals.Open (Line, Open);
      if not Open then
         return;
      end if;
      loop
         Before := Now;
         Of_Lines.Begin_At (Before);
         Unused := Libc.Write
           (Pseudo_Terminals.Device_End (Line), Byte'Address, 1);
         if Polls.Is_Readable (Pseudo_Terminals.Robot_End (Line), 10.0) then
            Time := Now;
            Unused := Libc.Read
              (Pseudo_Terminals.Robot_End (Line), Byte'Address, 1);
            Of_Lines.Add (Time - Before, (Before, Time));
         end if;
         delay Span;
      end loop;
   end Watch_Line;

   task body Watcher is
      Span : constant Duration := Duration (Turn) / 1_000;
   begin
      Own_Process.Prefer_Real_Time (True, Libc.Above_Supervisor + 1);
      if Processor = Not_A_Specific_CPU then
         Watch_Line (Span);
      else
         Watch_Processor (Processor, Span);
      end if;
   end Watcher;

   procedure Watch (Turn : Positive := 5; Lines : Boolean := False) is
      Unused : Watcher_Access;
   begin
      for Processor in (if Lines then Not_A_Specific_CPU else 1)
        .. Number_Of_CPUs
      loop
         Unused := new Watcher (Processor, Turn);
      end loop;
   end Watch;

   procedure Forget is
   begin
      Of_Processors.Clear;
      Of_Lines.Clear;
   end Forget;

   function Longest return Duration is (Of_Processors.Longest);

   function Longest_Line return Duration is (Of_Lines.Longest);

   procedure Tell
     (Since  : Instant;
      Action : not null access procedure (From, To : Instant))
   is
      procedure Tell_Of (Stalls : Stall_Array) is
      begin
         for Item of Stalls loop
            if Item.To > Since then
               Action (Item.From, Item.To);
            end if;
         end loop;
      end Tell_Of;

   begin
      Tell_Of (Of_Processors.Noted);
      Tell_Of (Of_Lines.Noted);
   end Tell;

   function Taken_By_Host return Duration is
      --  The eighth figure of the line: after user, nice, system, idle,
      --  waiting and two of interrupts
      Tick    : constant Duration := 0.01;
      --  of these figures, whatever the kernel's own is (USER_HZ)
      Figures : constant Arguments :=
        Words (Process_Facts.File_Line ("/proc/stat", "cpu "));
   begin
      return (if Figures.Last_Index < 9 then 0.0
              else Tick * Integer'Value (Figures (9)));
   end Taken_By_Host;

   function Has_Stood_Still (Host : Duration) return Boolean is
     (Duration'Max (Longest, Longest_Line) >= Too_Long
      or else Taken_By_Host - Host >= Too_Much);

   procedure Await_Calm (Limit : Duration) is
      While_Calm  : constant Duration := 2.0;
      Start       : constant Instant := Now;
      Host_Before : Duration;
   begin
      while Now - Start < Limit loop
         Forget;
         Host_Before := Taken_By_Host;
         delay While_Calm;
         exit when not Has_Stood_Still (Host_Before);
      end loop;
   end Await_Calm;

end Standstills;
