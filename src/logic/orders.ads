--  SPDX-License-Identifier: GPL-3.0-or-later
--  An order: a command of the monitor, passed to the task that carries it out.

with Interfaces;
with Monitor.Protocol;

package Orders with SPARK_Mode is

   type Ticket is new Interfaces.Unsigned_64;
   --  The number of a command, counted from 1 over the whole run: unique
   --  across sessions. 0: none

   Capacity : constant := 256;
   --  Commands that may wait for their answers (docs/wire.md, rule 2)

   subtype Order_Count is Natural range 0 .. Capacity;

   type Order is record
      Number  : Ticket := 0;
      Message : Monitor.Protocol.Message;
      Rank    : Ticket := 0;
      --  counts robot orders other than stops from 1 in each session
      After   : Ticket := 0;
      --  the rank of the last earlier order that changes the robot's session
      --  (opens, closes, starts, resets): it is carried out first. Of a
      --  mission: of the last earlier order with a rank
      Owed    : Boolean := False;
      --  its answer is still due, or later commands wait for it: the task that
      --  holds the order answers it or passes it on, once
   end record;

end Orders;
