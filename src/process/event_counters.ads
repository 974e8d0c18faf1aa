--  SPDX-License-Identifier: GPL-3.0-or-later
--  The kernel's event counters (eventfd): neither to set nor to take one
--  holds a lock that another task could wait for.

with Ada.Real_Time; use Ada.Real_Time;
with Interfaces.C;
with Process;

package Event_Counters with SPARK_Mode is

   type Counter is new Interfaces.C.int;
   --  Its descriptor: ready while the counter is not zero

   function New_Counter return Counter
   with Volatile_Function, Global => (Input => Process.System_State);
   --  If the system has none left, the process ends: it cannot start

   procedure Add (To : Counter)
   with Global   => (In_Out => Process.System_State),
        Annotate => (GNATprove, Terminating);
   --  Adds one. Does not block

   procedure Take
     (From   : Counter;
      Number : out Natural;
      Limit  : Time_Span := Time_Span_Last)
   with Global => (In_Out => Process.System_State);
   --  Waits until the counter is not zero, and sets it to zero; with a Limit
   --  no longer than that, or an hour, and not at all if it is not positive.
   --  Number is its former value, or 0 if it was still zero or a signal has
   --  interrupted the wait. With a Limit for one task only

end Event_Counters;
