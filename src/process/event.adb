--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time; use Ada.Real_Time;
with Event_Counters;

package body Event with SPARK_Mode is

   Counter : constant Event_Counters.Counter := Event_Counters.New_Counter;

   Times_Set : Natural := 0;
   --  Before the last Wait. Shared by nobody on purpose: a second task that
   --  waits is a data race

   procedure Take (Limit : Time := Time_Last) is
      --  Waits until the event has been set, or Limit
      Now : Time;
   begin
      loop
         Now := Clock;
         Event_Counters.Take
           (Counter, Times_Set,
            (if Limit = Time_Last then Time_Span_Last
             elsif Limit > Now then Limit - Now else Time_Span_Zero));
         exit when Times_Set > 0;
         Now := Clock;
         exit when Now >= Limit;
         --  a signal. GNATprove knows by the delay that this may block
         delay until Now + Milliseconds (1);
      end loop;
   end Take;

   procedure Set (Number : Commands.Ticket := 0) is
   begin
      Trace.Put (Trace.Release, Who, Number);
      Event_Counters.Add (Counter);
   end Set;

   procedure Wait is
   begin
      Trace.Put (Trace.Done, Who);
      Take;
      Trace.Put (Trace.Start, Who);
   end Wait;

   procedure Wait_Until (At_Time : Time; Was_Set : out Boolean) is
   begin
      Trace.Put (Trace.Done, Who);
      Take (At_Time);
      Was_Set := Times_Set > 0;
      if not Was_Set then
         Trace.Put_Due (Who, At_Time);
      end if;
      Trace.Put (Trace.Start, Who);
   end Wait_Until;

   procedure Wait_In_Job (Why : Trace.Label_Text) is
   begin
      Trace.Put (Trace.Wait, Who, Label => Why);
      Take;
      Trace.Put (Trace.Resume, Who);
   end Wait_In_Job;

end Event;
