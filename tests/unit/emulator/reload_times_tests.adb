--  SPDX-License-Identifier: GPL-3.0-or-later
--  The supervisor's reloads at the firmware's state machine.

with Robot.Line_Status; use Robot.Line_Status;
with Robot_Core;
with Robot_Motion;
with Unit_Runs;          use Unit_Runs;

procedure Reload_Times_Tests is

   use type Robot_Motion.Micro;

   procedure Send (R : in out Robot_Core.Robot; Letter : Character) is
      Code     : constant Robot_Core.Octet := Character'Pos (Letter);
      Complete : Boolean;
      Result   : Robot_Core.Exchange;
   begin
      --  the checksum of one letter is the letter
      for Byte of Robot_Core.Octets'(Code, Code, 16#0D#) loop
         Robot_Core.Receive (R, Byte, Complete, Result);
      end loop;
      Assert (Complete, "a whole frame");
   end Send;

   procedure Pass (R : in out Robot_Core.Robot; Span : Natural) is
      --  Milliseconds
   begin
      Robot_Core.Advance_To
        (R, Robot_Core.Clock (R) + Robot_Core.Time_Point (Span) * 1_000);
   end Pass;

   procedure Expect (Losses : String; Misses : Natural) is
      --  Losses: of one reload after the other: "." nothing, "c" the command,
      --  "a" its answer; wherever in the robot's 100 ms from tick to tick
   begin
      for Phase in 0 .. 99 loop
         declare
            R          : Robot_Core.Robot;
            Unanswered : Unanswered_Count := 0;
         begin
            Robot_Core.Switch_On (R);
            Pass (R, 2_000 + Phase);
            Send (R, 'W');
            for Loss of String'(Losses & "...") loop
               Pass (R, Interval_After (Unanswered));
               if Loss /= 'c' then
                  Send (R, 'w');
               end if;
               Unanswered :=
                 (if Loss = '.' then 0
                  else Unanswered_Count'Min (Unanswered, 1) + 1);
            end loop;
            Assert (Robot_Core.Watchdog_On (R)
                    and then Robot_Core.Missed_Total (R) = Misses
                    and then Robot_Core.Missed (R) = 0,
                    Losses & ", tick after" & Phase'Image & " ms: missed"
                    & Robot_Core.Missed_Total (R)'Image);
         end;
      end loop;
   end Expect;

   procedure Test_Losses is
   begin
      Expect ("", 0);
      Expect ("a", 0);
      Expect ("c", 1);
      Expect ("cc", 2);
      Expect ("ac", 1);
      Expect ("c.a.c.a", 2);
   end Test_Losses;

begin
   Run_Test ("reloads that are lost, or their answers", Test_Losses'Access);
end Reload_Times_Tests;
