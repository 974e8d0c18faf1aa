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
      --  start of the hold ...
      Since : Time := Time_First;
      --  ... and the same for the command that waits now
   end record;

   procedure Begin_Hold
     (H           : in out Hold;
      New_Command : Boolean;
      Now         : Time;
      Begun       : out Boolean)
   with
     Post => H.On and then Begun = not H'Old.On;
   --  Unsolicited messages and commands wait. New_Command: the command waits
   --  since now, and none did before

   function Ending (H : Hold) return Time is
     (if H.Since - H.First > Schedule.Hold_Limit
      then H.First + Schedule.Hold_Limit + Schedule.Hold_Limit
      else H.Since + Schedule.Hold_Limit)
   with Pre => H.On;
   --  A command holds them back for the limit at most; commands in a row, with
   --  no time for a message in between, for twice the limit

end Monitor.Message_Holds;
