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

end Event;
