--  SPDX-License-Identifier: GPL-3.0-or-later
--  The bare C program that forwards.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Both_Ends;             use Both_Ends;
with Child_Processes;       use Child_Processes;
with Expectations;          use Expectations;
with Own_Process;
with Programs;
with Schedule;

package body Forwarders is

   procedure Start
     (Process : in out Child;
      Where   : Place)
   is
      Number : Natural;
      Line   : Unbounded_String;
   begin
      Process.Start
        (Programs.Beside ("forwarder"),
         Words
           ("forward " & Device (Where)
            --  Linux counts priorities from 1
            & Integer'Image
                (if Own_Process.Real_Time_Allowed
                 then Schedule.Move_Priority + 1 else 0)));
      Number := Process.Awaited (Errors, "listening on", 5.0);
      Check (Number > 0, "the forwarder does not listen");
      Line := Process.Element (Errors, Number).Text;
      Connect
        (Where,
         Positive'Value (Slice (Line, Index (Line, ":") + 1, Length (Line))),
         By_Lines => False);
   end Start;

end Forwarders;
