--  SPDX-License-Identifier: GPL-3.0-or-later
--  How long unsolicited messages are held back while commands wait for their
--  answers (docs/wire.md, rule 7).

with Ada.Real_Time; use Ada.Real_Time;
with Schedule;

package Monitor.Message_Holds with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Monitor.Message_Holds);

   type Hold is record
      On    : Boolean := False;
      --  unsolicited messages are or were held back, and none was sent since
      First : Time := Time_First;
      --  when the hold began
      Since : Time := Time_First;
      --  when the command that waits now arrived
   end record;

   procedure Begin_Hold
     (H : in out Hold; New_Command : Boolean; Now : Time)
   with Post => H.On;
   --  Unsolicited messages wait because a command waits. New_Command: the
   --  command arrived just now, and no other was waiting

   function Ending (H : Hold) return Time is
     (if H.Since - H.First > Schedule.Hold_Limit
      then H.First + Schedule.Hold_Limit + Schedule.Hold_Limit
      else H.Since + Schedule.Hold_Limit)
   with Pre => H.On;
   --  One command holds the messages back for the limit at most. Commands that
   --  follow each other without time for a message hold them back for twice
   --  the limit

end Monitor.Message_Holds;
