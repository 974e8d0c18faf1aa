--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time;     use Ada.Real_Time;

with Bytes;
with Pseudo_Terminals;
with Robot.Serial_Line;
with Texts;
with Unit_Runs; use Unit_Runs;

procedure Serial_Line_Tests is

   procedure Test_Wait is
      Line    : Pseudo_Terminals.Line;
      Path    : Texts.Text;
      Reason  : Texts.Text;
      Done    : Boolean;
      Gone    : Boolean;
      Data    : Bytes.Byte_Array (1 .. 4);
      Length  : Natural;
      Limit   : Time;
      --  the kernel takes no nanoseconds of a second or more, and 32 bits
      --  hold 2.1 seconds of them
      Waits   : constant array (1 .. 4) of Time_Span :=
        (Milliseconds (-10), Milliseconds (20),
         Milliseconds (1_050), Milliseconds (2_200));
   begin
      Pseudo_Terminals.Open (Line, Done);
      Assert (Done, "no pseudo-terminal");
      Texts.Set (Path, Pseudo_Terminals.Device (Line));
      Robot.Serial_Line.Open (Path, Done, Reason);
      Assert (Done, Texts.Image (Reason));
      for Wait of Waits loop
         Limit := Clock + Wait;
         Robot.Serial_Line.Read (Data, Length, Limit, Gone);
         Assert (not Gone and then Length = 0, "the read failed");
         Assert (Clock >= Limit, "it did not wait for the time it was told");
      end loop;
      Robot.Serial_Line.Close (Done);
      Assert (Done, "something has not left");
      Pseudo_Terminals.Close (Line);
   end Test_Wait;

begin
   Run_Test ("a read waits as long as it is told", Test_Wait'Access);
end Serial_Line_Tests;
