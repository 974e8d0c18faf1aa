--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time; use Ada.Real_Time;
with Event_Counters;

package body Event with SPARK_Mode is

   Counter : constant Event_Counters.Counter := Event_Counters.New_Counter;

   Times_Set : Natural := 0;
   --  Before the last Wait. Shared by nobody on purpose: a second task that
   --  waits is a data race

   procedure Set is
   begin
      Event_Counters.Add (Counter);
   end Set;

   procedure Wait is
      Now : Time;
   begin
      loop
         Event_Counters.Take (Counter, Times_Set);
         exit when Times_Set > 0;
         --  a signal. GNATprove knows by the delay that this may block
         Now := Clock;
         delay until Now + Milliseconds (1);
      end loop;
   end Wait;

   procedure Wait_Until (At_Time : Time; Was_Set : out Boolean) is
      Now : Time;
   begin
      loop
         Now := Clock;
         Event_Counters.Take_Within
           (Counter,
            (if At_Time > Now then At_Time - Now else Time_Span_Zero),
            Times_Set);
         Now := Clock;
         exit when Times_Set > 0 or else Now >= At_Time;
         --  a signal, as above
         delay until Now + Milliseconds (1);
      end loop;
      Was_Set := Times_Set > 0;
   end Wait_Until;

end Event;
