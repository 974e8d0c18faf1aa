--  SPDX-License-Identifier: GPL-3.0-or-later
--  An order: a command of the monitor, passed to the task that carries it out.

with Commands;
with Interfaces;

package Orders with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Orders);

   type Ticket is new Interfaces.Unsigned_64;
   --  The number of a command, counted from 1 over the whole run: unique
   --  across sessions. 0: none

   Capacity : constant := 256;
   --  Commands that may wait for their answers (docs/wire.md, rule 2)

   subtype Order_Count is Natural range 0 .. Capacity;

   type Order is record
      Number  : Ticket := 0;
      Command : Commands.Command;
      After   : Ticket := 0;
      --  the last earlier order that changes the robot's session (opens,
      --  closes, starts, resets), which is carried out first
      Owed    : Boolean := False;
      --  its answer is still due, or later commands wait for it: the task that
      --  holds the order answers it or passes it on, once
   end record;

end Orders;
