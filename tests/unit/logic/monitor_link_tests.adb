--  SPDX-License-Identifier: GPL-3.0-or-later
--  The monitor's connection: present, vanished, stalled.

with AUnit.Assertions; use AUnit.Assertions;

with Monitor.Link;     use Monitor.Link;
with Texts;
with Unit_Runs; use Unit_Runs;

package body Monitor_Link_Tests is

   Step : constant Milliseconds := 250;

   S   : State;
   Now : Milliseconds := 0;

   procedure Begin_At (Time : Milliseconds) is
      --  A connection is admitted.
   begin
      Now := Time;
      Start (S, Now);
   end Begin_At;

   function Next
     (Unacknowledged : Natural;
      Since_Heard    : Milliseconds;
      Outstanding    : Natural;
      Bytes_Acked    : Byte_Count) return Verdict
   is
      --  The verdict on the sample after 250 ms more.
      V : Verdict;
   begin
      Now := Now + Step;
      Judge (S,
             (Now            => Now,
              Known          => True,
              Unacknowledged => Unacknowledged,
              Since_Heard    => Since_Heard,
              Outstanding    => Outstanding,
              Bytes_Acked    => Bytes_Acked),
             V);
      return V;
   end Next;

   procedure Test_After_Silence is
   begin
      --  It was kept waiting for 20 s before it was admitted; a slow way to
      --  it, and no sign of life since, but nothing was asked of it

      Begin_At (0);
      for I in 1 .. 16 loop
         Assert (Next (1, 20_000 + Milliseconds (I) * Step, 7, 0) = Present,
                 "just admitted");
      end loop;
      Assert (Next (0, 20, 0, 7) = Present, "acknowledged");

      --  Its window was closed, and the kernel's probes have become rare

      for I in 1 .. 40 loop
         Assert (Next (0, Milliseconds (I) * Step, 9, 7) = Present,
                 "closed window");
      end loop;
      Assert (Next (1, 10_250, 9, 7) = Present, "just sent");
      Assert (Next (1, 10, 9, 16) = Present, "acknowledged");
   end Test_After_Silence;

   procedure Test_Both is
   begin
      Begin_At (0);
      for I in 1 .. 70 loop
         Assert (Next (0, 100, 5000, 9) =
                 (if I > 60 then Stalled else Present), "stalled");
      end loop;
      for I in 1 .. 17 loop
         Assert (Next (2, Milliseconds (I) * Step, 5000, 9) =
                 (if I = 17 then Vanished else Stalled), "then vanished");
      end loop;
   end Test_Both;

   procedure Test_Clock is
      V : Verdict;
   begin
      --  A time before the last one counts as no time at all

      Begin_At (1_000);
      Judge (S, (Now => 5, Known => True, Unacknowledged => 1,
                 Since_Heard => 9_999, Outstanding => 1, Bytes_Acked => 0), V);
      Assert (V = Present, "earlier than the start");
      Judge (S, (Now => 0, Known => True, Unacknowledged => 1,
                 Since_Heard => 9_999, Outstanding => 1, Bytes_Acked => 0), V);
      Assert (V = Present, "earlier again");
      Judge (S, (Now => Milliseconds'Last, Known => True,
                 Unacknowledged => Natural'Last,
                 Since_Heard => Milliseconds'Last,
                 Outstanding => Natural'Last, Bytes_Acked => 0), V);
      Assert (V = Vanished, "a long time");

      --  Whatever moves the counter is progress

      Judge (S, (Now => Milliseconds'Last, Known => True,
                 Unacknowledged => 1, Since_Heard => 9_999, Outstanding => 1,
                 Bytes_Acked => Byte_Count'Last), V);
      Assert (V = Present, "progress");
   end Test_Clock;

   procedure Test_Length is
      --  Of struct tcp_info up to and with the last field before
      --  tcpi_notsent_bytes, and with that one
   begin
      for Length in 0 .. 147 loop
         Assert (not Is_Enough (Length), "too little");
      end loop;
      for Length in 148 .. 300 loop
         Assert (Is_Enough (Length), "enough");
      end loop;
   end Test_Length;

   procedure Test_Loss is
   begin
      for Error in 0 .. 133 loop
         for Broken in Boolean loop
            Assert
              (Loss_Of (False, Broken, Error) = None, "nothing has happened");
            Assert
              (Loss_Of (True, Broken, Error) =
                 (if Error in 110 | 113 then No_Sign_Of_Life
                  elsif Broken then Reset_By_Peer
                  else Closed_By_Peer),
               "error" & Error'Image);
         end loop;
      end loop;
   end Test_Loss;

   procedure Test_Pause is
      Acked : Byte_Count := 0;
   begin
      Begin_At (0);
      for Round in 1 .. 10 loop
         for I in 1 .. 59 loop
            Assert (Next (0, 200, 900, Acked) = Present, "14.5 s");
         end loop;
         Acked := Acked + 1;
         Assert (Next (0, 200, 900, Acked) = Present, "one byte is enough");
      end loop;
   end Test_Pause;

   procedure Test_Quiet is
   begin
      Begin_At (1_000_000);
      for I in 1 .. 20_000 loop
         Assert (Next (0, Milliseconds (I) * Step, 0, 1) = Present, "idle");
      end loop;
   end Test_Quiet;

   procedure Test_Slow is
   begin
      Begin_At (0);
      for I in 1 .. 1_000 loop
         Assert (Next (1, 100, 100_000, Byte_Count (I / 20)) = Present,
                 "a byte every 5 s");
      end loop;
   end Test_Slow;

   procedure Test_Stalled is
      First : Milliseconds;
   begin
      Begin_At (500);
      Assert (Next (0, 100, 0, 10) = Present, "nothing outstanding");
      First := Now + Step;
      for I in 1 .. 60 loop
         Assert (Next (0, 150, 131_072, 10) = Present, "window closed");
      end loop;
      Assert (Next (0, 150, 131_072, 10) = Stalled, "15 s");
      Assert (Now - First = 15_000, "exactly 15 s");

      --  The kernel's probes are acknowledged more and more rarely; with
      --  no segment under way that is no sign of a peer that has gone

      Begin_At (0);
      for I in 1 .. 60 loop
         Assert (Next (0, Milliseconds (I) * Step, 9, 0) = Present,
                 "old acknowledgements");
      end loop;
      Assert (Next (0, 15_000, 9, 0) = Stalled, "stalled, not vanished");
   end Test_Stalled;

   procedure Test_Streaming is
   begin
      Begin_At (0);
      for I in 1 .. 10_000 loop
         Assert (Next (3, 40, 60_000, Byte_Count (I) * 50_000) = Present,
                 "in full flow");
      end loop;
   end Test_Streaming;

   procedure Test_Vanished is
      Cut : Milliseconds;
      V   : Verdict := Present;
   begin
      --  The cable goes at every phase of the sampling; images follow each
      --  other every 100 ms, so the first unacknowledged one goes out at
      --  most 100 ms later

      for Phase in Milliseconds range 0 .. 249 loop
         Begin_At (0);
         Assert (Next (0, 10, 0, 5_000) = Present, "before");
         Cut := Now + Phase;
         V := Present;
         while V = Present loop
            V := (if Now + Step <= Cut + 100
                  then Next (0, 20, 0, 5_000)
                  else Next (1, Now + Step - Cut, 40_000, 5_000));
            Assert (Now - Cut < 5_000, "within 5 s");
         end loop;
         Assert (V = Vanished, "vanished");
         Assert (Now - Cut > 4_000, "not before 4 s");
      end loop;
   end Test_Vanished;

   procedure Test_Vanished_Idle is
      Cut  : Milliseconds;
      Sent : Milliseconds;
      V    : Verdict;
   begin
      --  The cable goes at every phase of the sampling, and something is
      --  sent at any time before the kernel's own keep-alive would have
      --  found it, 4 s later: from then on that no longer counts

      for Phase in Milliseconds range 0 .. 249 loop
         for Later in Milliseconds range 0 .. 79 loop
            Begin_At (0);
            for I in 1 .. 20 loop
               Assert (Next (0, 10, 0, 5_000) = Present, "before");
            end loop;
            Cut := Now + Phase;
            Sent := Cut + Later * 50;
            V := Present;
            while V = Present loop
               V := Next
                 (Unacknowledged => (if Now + Step > Sent then 1 else 0),
                  Since_Heard    =>
                    (if Now + Step > Cut then Now + Step - Cut else 10),
                  Outstanding    => (if Now + Step > Sent then 7 else 0),
                  Bytes_Acked    => 5_000);
               Assert (Now - Cut < 5_000, "within 5 s");
            end loop;
            Assert (V = Vanished, "vanished");
            Assert (Now - Cut > 4_000, "not before 4 s");
         end loop;
      end loop;
   end Test_Vanished_Idle;

   procedure Test_Cause is

      procedure Check
        (Stopping : Boolean;
         Loss     : Loss_Kind;
         V        : Verdict;
         Expected : String)
      is
         Line : Texts.Text;
      begin
         Append (Line, Cause_Of (Stopping, Loss, V));
         Assert (Texts.Image (Line) = Expected,
                 Expected & " expected, not " & Texts.Image (Line));
      end Check;
   begin
      Check (False, None, Present, "");
      Check (True, Closed_By_Peer, Vanished, "the supervisor is stopping");
      Check (False, Closed_By_Peer, Present, "connection closed");
      Check (False, Reset_By_Peer, Stalled, "connection reset");
      Check (False, No_Sign_Of_Life, Present,
             "it vanished, no sign of life for 4 s");
      Check (False, None, Vanished,
             "it vanished, nothing has been acknowledged for 4 s");
      Check (False, None, Stalled, "it has taken nothing for 15 s");
   end Test_Cause;

   procedure Test_Time is
   begin
      Assert (Time_Of (0, 0) = 0, "start");
      Assert (Time_Of (12, 345) = 12_345, "milliseconds");
      Assert (Time_Of (3_000_000_000, 999) = 3_000_000_000_999, "a century");
      Assert (Time_Of (Seconds'First, -1) = 0, "before the start");
      Assert (Time_Of (Seconds'Last, 0) = 2 ** 50 * 1_000, "for ever");
   end Test_Time;

   procedure Add_Tests is
   begin
      Add_Test ("nothing to say, for hours", Test_Quiet'Access);
      Add_Test ("images, acknowledged", Test_Streaming'Access);
      Add_Test ("F5: vanished, found within 5 s", Test_Vanished'Access);
      Add_Test ("F5: vanished while idle, a message follows",
                Test_Vanished_Idle'Access);
      Add_Test ("first message after a long silence",
                Test_After_Silence'Access);
      Add_Test ("stalled: closed window for 15 s", Test_Stalled'Access);
      Add_Test ("slow is not stalled", Test_Slow'Access);
      Add_Test ("pauses below the limit, again and again", Test_Pause'Access);
      Add_Test ("vanished goes first", Test_Both'Access);
      Add_Test ("odd clocks, odd counters", Test_Clock'Access);
      Add_Test ("why a session ends", Test_Cause'Access);
      Add_Test ("what the kernel gives", Test_Length'Access);
      Add_Test ("what ended the connection", Test_Loss'Access);
      Add_Test ("the time of a sample", Test_Time'Access);
   end Add_Tests;

end Monitor_Link_Tests;
