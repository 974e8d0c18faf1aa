--  SPDX-License-Identifier: GPL-3.0-or-later
--  How long unasked messages are held back while commands wait for their
--  answers (PROTOCOL rule 7).

with Ada.Real_Time; use Ada.Real_Time;
with Schedule;

package Monitor.Message_Holds with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Monitor.Message_Holds);
   --  A claim that GNATprove checks: every subprogram ends

   type Hold is record
      On    : Boolean := False;
      --  unasked messages are held back, or were, and none was sent since
      First : Time := Time_First;
      --  from then on ...
      Since : Time := Time_First;
      --  ... and from then on for the command that waits now
   end record;

   procedure Begin_Hold
     (H           : in out Hold;
      New_Command : Boolean;
      Now         : Time;
      Begun       : out Boolean)
   with
     Post => H.On and then Begun = not H'Old.On;
   --  Unasked messages wait, and commands do. New_Command: since now; there
   --  was none before

   function Ending (H : Hold) return Time is
     (if H.Since - H.First > Schedule.Hold_Limit
      then H.First + Schedule.Hold_Limit + Schedule.Hold_Limit
      else H.Since + Schedule.Hold_Limit)
   with Pre => H.On;
   --  Each command holds them back for the limit at most; commands in a row,
   --  each with no time left for a message before the next, for twice that

end Monitor.Message_Holds;
