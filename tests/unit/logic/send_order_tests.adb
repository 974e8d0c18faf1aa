--  SPDX-License-Identifier: GPL-3.0-or-later
--  What goes to the monitor next, and how long after the message before it.

with AUnit.Assertions;   use AUnit.Assertions;

with Monitor.Send_Order; use Monitor.Send_Order;
with Unit_Runs; use Unit_Runs;

procedure Send_Order_Tests is

   Everything : constant Unsolicited_Set := (others => True);

   procedure Send (W : in out Waiting; Expected : Choice) is
      --  It is next, and is sent
      Sent : constant Choice := Next (W);
   begin
      Assert (Sent = Expected, Sent'Image & " instead of " & Expected'Image);
      if Sent in Unsolicited then
         W.Messages (Sent) := False;
      end if;
      W.Last := Sent;
      W.Imaged := Sent = Image or else (W.Imaged and then Sent /= Position);
   end Send;

   procedure Test_Order is
      W : Waiting := (Open => True, Messages => Everything, others => <>);
   begin
      W.Commands := True;
      W.Ready := True;
      Send (W, Answer);
      W.Commands := False;
      W.Ready := False;
      Send (W, Robot_Lost);
      Send (W, Text);
      Send (W, Mission);
      Send (W, Battery);
      Send (W, Image);
      Send (W, Position);
      Assert (Next (W) = Nothing, "nothing is left");
      W.Messages := Everything;
      W.Open := False;
      Assert (Next (W) = Nothing, "there is no monitor");
   end Test_Order;

   procedure Test_Turns is
      W : Waiting := (Open => True, Messages => Everything, others => <>);
   begin
      Send (W, Robot_Lost);
      Send (W, Text);
      Send (W, Mission);
      --  a monitor so slow that there are always new ones of both
      for Round in 1 .. 3 loop
         W.Messages (Battery) := True;
         Send (W, Battery);
         Send (W, Image);
         W.Messages (Image) := True;
         W.Messages (Battery) := True;
         Send (W, Battery);
         Send (W, Position);
         W.Messages (Position) := True;
      end loop;
      --  one without the other
      W.Messages (Image) := False;
      Send (W, Position);
      W.Messages (Image) := True;
      Send (W, Image);
      W.Messages (Image) := True;
      Send (W, Image);
   end Test_Turns;

   procedure Test_Gap is

      procedure Check
        (Last, Sent : Choice;
         Between    : Milliseconds;
         Expected   : Milliseconds;
         Released   : Boolean := False)
      is
         Value : constant Milliseconds :=
           Gap
             ((Open     => True,
               Last     => Last,
               Released => Released,
               others   => <>),
              Sent, Between);
      begin
         Assert (Value = Expected,
                 Sent'Image & " after " & Last'Image & ":" & Value'Image);
      end Check;

   begin
      Check (Nothing, Image, 20, 0);
      Check (Image, Position, 20, 20);
      Check (Position, Battery, 20, 20);
      Check (Image, Answer, 20, 4);
      Check (Image, Answer, 3, 3);
      Check (Image, Answer, 0, 0);
      Check (Answer, Answer, 20, 0);
      Check (Answer, Image, 20, 20);
      Check (Answer, Image, 20, 4, Released => True);
      Check (Answer, Image, 0, 0, Released => True);
      Check (Image, Battery, 20, 20, Released => True);
      Check (Image, Answer, 1_000, 4);
      Check (Image, Nothing, 20, 0);
   end Test_Gap;

begin
   Run_Test ("most urgent first", Test_Order'Access);
   Run_Test ("image and position in turn", Test_Turns'Access);
   Run_Test ("the gap by default", Test_Gap'Access);
end Send_Order_Tests;
