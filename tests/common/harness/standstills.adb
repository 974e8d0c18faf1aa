--  SPDX-License-Identifier: GPL-3.0-or-later
--  Detects stalls of this machine's processors.

with Interfaces.C; use type Interfaces.C.int;
with System.Multiprocessors.Dispatching_Domains;

with Host_Time;
with Libc;
with Own_Process;

package body Standstills is

   use System.Multiprocessors;

   Noted : constant Duration := 0.000_5;

   type Stall is record
      From, To : Instant := Never;
   end record;

   type Stall_Number is mod 8_192;

   type Stall_Array is array (Stall_Number) of Stall;

   protected Record_Of_All is
      procedure Add (Gap : Duration; Item : Stall);
      procedure Clear;
      function Longest return Duration;
      function Next_After (Time : Instant) return Stall;
      --  The one that begins first of those that end after Time
   private
      Worst  : Duration := 0.0;
      Stalls : Stall_Array;
      Place  : Stall_Number := 0;
   end Record_Of_All;

   task type Watcher (Processor : CPU; Turn : Positive);

   type Watcher_Access is access Watcher;

   protected body Record_Of_All is

      procedure Add (Gap : Duration; Item : Stall) is
      begin
         Worst := Duration'Max (Worst, Gap);
         if Gap >= Noted then
            Stalls (Place) := Item;
            Place := Place + 1;
         end if;
      end Add;

      procedure Clear is
      begin
         Worst := 0.0;
      end Clear;

      function Longest return Duration is (Worst);

      function Next_After (Time : Instant) return Stall is
         Result : Stall;
      begin
         for Item of Stalls loop
            if Item.To > Time
              and then (Result.To = Never or else Item.From < Result.From)
            then
               Result := Item;
            end if;
         end loop;
         return Result;
      end Next_After;

   end Record_Of_All;

   task body Watcher is
      Span   : constant Duration := Duration (Turn) / 1_000;
      Before : Instant;
      Time   : Instant;
   begin
      begin
         Dispatching_Domains.Set_CPU (Processor);
      exception
         when Dispatching_Domains.Dispatching_Domain_Error =>
            null;  --  it may not run there: it stays where it is
      end;
      Own_Process.Prefer_Real_Time (True, Libc.Above_Supervisor + 1);
      loop
         Before := Now;
         delay Span;
         Time := Now;
         Record_Of_All.Add (Time - Before - Span, (Before, Time));
      end loop;
   end Watcher;

   procedure Watch (Turn : Positive := 5) is
      Unused : Watcher_Access;
   begin
      for Processor in 1 .. Number_Of_CPUs loop
         Unused := new Watcher (Processor, Turn);
      end loop;
   end Watch;

   procedure Forget is
   begin
      Record_Of_All.Clear;
   end Forget;

   function Longest return Duration is (Record_Of_All.Longest);

   function Within (From, To : Instant) return Duration is
      Time   : Instant := From;
      Item   : Stall;
      Result : Duration := 0.0;
   begin
      loop
         Item := Record_Of_All.Next_After (Time);
         exit when Item.To = Never or else Item.From >= To;
         Time := Instant'Max (Time, Item.From);
         Result := Result + (Instant'Min (To, Item.To) - Time);
         Time := Item.To;
         exit when Time >= To;
      end loop;
      return Result;
   end Within;

   procedure Await_Calm (Limit : Duration) is
      While_Calm  : constant Duration := 2.0;
      Start       : constant Instant := Now;
      Host_Before : Duration;
   begin
      while Now - Start < Limit loop
         Forget;
         Host_Before := Host_Time.Taken;
         delay While_Calm;
         exit when Longest < Too_Long
           and then Host_Time.Taken - Host_Before < Too_Much;
      end loop;
   end Await_Calm;

end Standstills;
