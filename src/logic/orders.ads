--  SPDX-License-Identifier: GPL-3.0-or-later
--  An order: a command of the monitor, passed to the task that carries it out.

with Commands; use Commands;
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
      Rank    : Ticket := 0;
      --  counts robot commands other than stops from 1 in each session
      After   : Ticket := 0;
      --  the rank of the last earlier order that changes the robot's session
      --  (opens, closes, starts, resets): it is carried out first. Of a
      --  mission: of the last earlier order with a rank
      Owed    : Boolean := False;
      --  its answer is still due, or later commands wait for it: the task that
      --  holds the order answers it or passes it on, once
   end record;

   type Ranks is record
      Last   : Ticket := 0;
      --  rank of the session's last ranked order
      Change : Ticket := 0;
      --  the same of the last that changes the robot's session
   end record;

   procedure Give_Rank (R : in out Ranks; Item : in out Order)
   with
     Post => Item.Number = Item'Old.Number
       and then Item.Command = Item'Old.Command
       and then Item.Owed = Item'Old.Owed
       and then
         (if Has_Rank (Item.Command.Name) then
             Item.Rank = R'Old.Last + 1
             and then Item.After = R'Old.Change
             and then R.Last = Item.Rank
             and then R.Change =
               (if Changes_Session (Item.Command.Name) then Item.Rank
                else R'Old.Change)
          else R = R'Old
            and then Item.Rank = 0
            and then Item.After =
              (if Item.Command.Name in Mission_Command then R.Last else 0));
   --  A mission's orders to the robot follow all earlier ones

end Orders;
