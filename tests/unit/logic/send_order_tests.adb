--  SPDX-License-Identifier: GPL-3.0-or-later
--  What goes to the monitor next, and how long after the message before it.

with AUnit.Assertions;   use AUnit.Assertions;

with Monitor.Send_Order; use Monitor.Send_Order;
with Unit_Runs; use Unit_Runs;

package body Send_Order_Tests is

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

   procedure Test_Hold is
      W : Waiting :=
        (Open     => True,
         Commands => True,
         Messages => (Battery | Image => True, others => False),
         others   => <>);
   begin
      Assert (Next (W) = Nothing, "held back");
      W.Released := True;
      Send (W, Battery);
      W.Ready := True;
      Send (W, Answer);
      Send (W, Image);
      Send (W, Answer);
      W.Messages := Everything;
      W.Released := False;
      Send (W, Answer);
      Send (W, Answer);
   end Test_Hold;

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
         Assert
           (Value = Expected,
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

   procedure Test_Every_Gap is
      --  An answer never waits for more than two short gaps and a message in
      --  between, whatever else there is
      W : Waiting;
   begin
      for Released in Boolean loop
         for Last in Choice loop
            for Kind in Unsolicited loop
               for Between in Milliseconds loop
                  W := (Open     => True,
                        Commands => True,
                        Ready    => True,
                        Released => Released,
                        Last     => Last,
                        others   => <>);
                  W.Messages (Kind) := True;
                  Assert
                    (Gap (W, Next (W), Between)
                     <= Milliseconds'Min (Between, Answer_Gap),
                     "an answer waits for long");
                  if Last in Unsolicited then
                     Assert
                       (Gap (W, Kind, Between) = Between,
                        "two unsolicited ones are not kept apart");
                  end if;
               end loop;
            end loop;
         end loop;
      end loop;
   end Test_Every_Gap;

   procedure Add_Tests is
   begin
      Add_Test ("most urgent first", Test_Order'Access);
      Add_Test ("image and position in turn", Test_Turns'Access);
      Add_Test ("rule 7: the hold", Test_Hold'Access);
      Add_Test ("the gap by default", Test_Gap'Access);
      Add_Test ("every gap", Test_Every_Gap'Access);
   end Add_Tests;

end Send_Order_Tests;
