--  SPDX-License-Identifier: GPL-3.0-or-later
--  An order: a command of the monitor on its way to the task that carries
--  it out.

with Interfaces;
with Monitor.Protocol;

package Orders with SPARK_Mode is

   type Ticket is new Interfaces.Unsigned_64;
   --  The number of a command, counted from 1 over the whole run: no two
   --  commands of any two sessions share one. 0: none

   Capacity : constant := 256;
   --  How many commands may be waiting for their answers (PROTOCOL rule 2)

   subtype Order_Count is Natural range 0 .. Capacity;

   type Order is record
      Number  : Ticket := 0;
      Message : Monitor.Protocol.Message;
      Rank    : Ticket := 0;
      --  robot orders but stops, counted from 1 in each session
      After   : Ticket := 0;
      --  the rank of the last order before this one that changes the
      --  robot's session (opens, closes, starts, resets): it comes first
      Owed    : Boolean := False;
      --  the monitor waits for its answer, or later commands do: whoever
      --  has the order gives it or passes the order on, once
   end record;

end Orders;
