--  SPDX-License-Identifier: GPL-3.0-or-later
--  Detects stalls of this machine's processors.

with System.Multiprocessors.Dispatching_Domains;

with Host_Time;
with Instants;     use Instants;
with Own_Process;

package body Standstills is

   use System.Multiprocessors;

   Turn : constant Duration := 0.005;

   protected Record_Of_All is
      procedure Add (Gap : Duration);
      procedure Clear;
      function Longest return Duration;
   private
      Worst : Duration := 0.0;
   end Record_Of_All;

   task type Watcher (Processor : CPU);

   type Watcher_Access is access Watcher;

   protected body Record_Of_All is

      procedure Add (Gap : Duration) is
      begin
         Worst := Duration'Max (Worst, Gap);
      end Add;

      procedure Clear is
      begin
         Worst := 0.0;
      end Clear;

      function Longest return Duration is (Worst);

   end Record_Of_All;

   task body Watcher is
      Before : Instant;
   begin
      begin
         Dispatching_Domains.Set_CPU (Processor);
      exception
         when Dispatching_Domains.Dispatching_Domain_Error =>
            null;  --  it may not run there: it stays where it is
      end;
      Own_Process.Prefer_Real_Time (True);
      loop
         Before := Now;
         delay Turn;
         Record_Of_All.Add (Now - Before - Turn);
      end loop;
   end Watcher;

   procedure Watch is
      Unused : Watcher_Access;
   begin
      for Processor in 1 .. Number_Of_CPUs loop
         Unused := new Watcher (Processor);
      end loop;
   end Watch;

   procedure Forget is
   begin
      Record_Of_All.Clear;
   end Forget;

   function Longest return Duration is (Record_Of_All.Longest);

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
