--  SPDX-License-Identifier: GPL-3.0-or-later
--  The kernel's event counters (eventfd): neither to set nor to take one
--  holds a lock that another task could wait for.

with Ada.Real_Time;
with Interfaces.C;

package Event_Counters with
  SPARK_Mode,
  Abstract_State =>
    (Kernel with Synchronous, External => (Async_Readers, Async_Writers)),
  Initializes => Kernel
is

   type Counter is private;

   function Descriptor (C : Counter) return Interfaces.C.int;
   --  To wait for it with others: ready while the counter is not zero

   function New_Counter return Counter
   with Volatile_Function, Global => (Input => Kernel);
   --  If the system has none left, the process ends: it cannot start

   procedure Add (To : Counter)
   with Global   => (In_Out => Kernel),
        Annotate => (GNATprove, Terminating);
   --  Adds one. Does not block

   procedure Take (From : Counter; Number : out Natural)
   with Global => (In_Out => Kernel);
   --  Waits until the counter is not zero, and sets it to zero. Number is its
   --  former value, or 0 if a signal has interrupted the wait

   procedure Take_Within
     (From : Counter; Limit : Ada.Real_Time.Time_Span; Number : out Natural)
   with Global => (In_Out => Kernel);
   --  The same, but waits no longer than Limit, or an hour, and not at all if
   --  Limit is not positive. Number is 0 if the counter was still zero. For
   --  one task only

private

   type Counter is range -1 .. 2 ** 31 - 1 with Size => 32;

   function Descriptor (C : Counter) return Interfaces.C.int is
     (Interfaces.C.int (C));

end Event_Counters;
