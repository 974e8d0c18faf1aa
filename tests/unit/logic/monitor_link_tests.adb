--  SPDX-License-Identifier: GPL-3.0-or-later
--  The monitor's connection: present, vanished, unreachable, silent, stalled.

with Interfaces;       use Interfaces;
with Monitor.Link;     use Monitor.Link;
with Texts;
with Unit_Runs; use Unit_Runs;

procedure Monitor_Link_Tests is

   Step : constant Milliseconds := 100;
   --  Schedule.Link_Period

   S   : State;
   Now : Milliseconds := 0;

   procedure Begin_At (Time : Milliseconds) is
      --  A connection is admitted.
   begin
      Now := Time;
      S := Started (Now);
   end Begin_At;

   Open   : constant Unsigned_32 := 64_512;
   Closed : constant Unsigned_32 := 0;
   --  windows

   function Next
     (Unacknowledged : Unsigned_32;
      Since_Heard    : Milliseconds;
      Outstanding    : Unsigned_64;
      Bytes_Acked    : Unsigned_64;
      Window         : Unsigned_32  := Open;
      Probes         : Unsigned_32  := 0;
      Patience       : Milliseconds := Milliseconds'Last;
      Since_Data     : Milliseconds := Milliseconds'Last) return Verdict
   is
      --  The verdict on the sample after a period more.
      X : constant Sample :=
        (Now            => Now + Step,
         Known          => True,
         Patience       => Patience,
         Unacknowledged => Unacknowledged,
         Outstanding    => Outstanding,
         Window         => Window,
         Probes         => Probes,
         Since_Heard    => Since_Heard,
         Since_Data     => Since_Data,
         Bytes_Acked    => Bytes_Acked);
   begin
      Now := X.Now;
      S := After (S, X);
      return Verdict_On (S, X);
   end Next;

   procedure Test_After_Silence is
   begin
      --  It was kept waiting for 20 s before it was admitted; a slow way to
      --  it, and no sign of life since, but nothing was asked of it

      Begin_At (0);
      for I in 1 .. 40 loop
         Assert (Next (1, 20_000 + Milliseconds (I) * Step, 7, 0) = Present,
                 "just admitted");
      end loop;
      Assert (Next (0, 20, 0, 7) = Present, "acknowledged");

      --  Its window was closed, and the kernel's probes have become rare

      for I in 1 .. 100 loop
         Assert (Next (0, Milliseconds (I) * Step, 9, 7, Closed) = Present,
                 "closed window");
      end loop;
      Assert (Next (0, 10_100, 9, 7, Closed, Probes => 1) = Present,
              "just probed");
      Assert (Next (0, 90, 9, 7, Closed) = Present, "answered");
      Assert (Next (1, 190, 9, 7) = Present, "open, and just sent");
      Assert (Next (1, 10, 9, 16) = Present, "acknowledged");
   end Test_After_Silence;

   procedure Test_Both is
   begin
      Begin_At (0);
      for I in 1 .. 170 loop
         Assert (Next (0, 100, 5000, 9, Closed) =
                 (if I > 150 then Stalled else Present), "stalled");
      end loop;
      for I in 1 .. 41 loop
         Assert (Next (0, Milliseconds (I) * Step, 5000, 9, Closed,
                       Probes => 1) =
                 (if I = 41 then Vanished else Stalled), "then vanished");
      end loop;
   end Test_Both;

   procedure Test_Pause is
      Acked : Unsigned_64 := 0;
   begin
      Begin_At (0);
      for Round in 1 .. 10 loop
         for I in 1 .. 149 loop
            Assert (Next (0, 200, 900, Acked, Closed) = Present, "14.9 s");
         end loop;
         Acked := Acked + 1;
         Assert (Next (0, 200, 900, Acked, Closed) = Present,
                 "one byte is enough");
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
         Assert (Next (1, 100, 100_000, Unsigned_64 (I / 35)) = Present,
                 "a byte every 7 s");
         Assert (Next (1, 100, 100_000, Unsigned_64 (I / 35), Closed)
                 = Present,
                 "which closes the window meanwhile");
      end loop;
   end Test_Slow;

   procedure Test_Stalled is
      First : Milliseconds;
   begin
      Begin_At (500);
      Assert (Next (0, 100, 0, 10) = Present, "nothing outstanding");
      First := Now + Step;
      for I in 1 .. 150 loop
         Assert
           (Next (0, 150, 131_072, 10, Closed) = Present, "window closed");
      end loop;
      Assert (Next (0, 150, 131_072, 10, Closed) = Stalled, "15 s");
      Assert (Now - First = 15_000, "exactly 15 s");

      --  It drops what is sent to it for want of room, and says so

      Begin_At (0);
      for I in 1 .. 150 loop
         Assert (Next (1, 150, 9_000, 0, Closed) = Present, "no room");
      end loop;
      Assert (Next (1, 150, 9_000, 0, Closed) = Stalled, "no room for 15 s");

      --  The kernel's probes are acknowledged more and more rarely; while
      --  none is under way that is no sign of a peer that has gone

      Begin_At (0);
      for I in 1 .. 150 loop
         Assert (Next (0, Milliseconds (I) * Step, 9, 0, Closed) = Present,
                 "old acknowledgements");
      end loop;
      Assert
        (Next (0, 15_000, 9, 0, Closed) = Stalled, "stalled, not vanished");
   end Test_Stalled;

   procedure Test_Streaming is
   begin
      Begin_At (0);
      for I in 1 .. 10_000 loop
         Assert (Next (3, 40, 60_000, Unsigned_64 (I) * 50_000) = Present,
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

      for Phase in Milliseconds range 0 .. Step - 1 loop
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

   procedure Test_One_Way is
      --  Nothing gets to it, or can be sent at all, but it is heard: at every
      --  phase of the sampling and of the battery's level. Then its window
      --  is closed, and it is only stalled
      Cut  : Milliseconds;
      Sent : Milliseconds;
      V    : Verdict;
   begin
      for Window in Closed .. 1 loop
         for Unsent in Boolean loop
            for Phase in Milliseconds range 0 .. Step - 1 loop
               Begin_At (0);
               Assert (Next (0, 10, 0, 5_000) = Present, "before");
               Cut := Now + Phase;
               Sent := Cut + 499 - Phase;
               V := Present;
               while V = Present loop
                  V :=
                    (if Now + Step <= Sent then Next (0, 20, 0, 5_000)
                     else Next
                       (Boolean'Pos (not Unsent), 20, 7, 5_000, Window));
                  Assert
                    (Now - Cut < (if Window = Closed then 16_000 else 4_900),
                     "within 5 s, and the stop");
               end loop;
               Assert (V = (if Window = Closed then Stalled
                            elsif Unsent then Unreachable
                            else Vanished),
                       V'Image);
            end loop;
         end loop;
      end loop;
   end Test_One_Way;

   procedure Test_Unreachable is
      Cut : Milliseconds;
      V   : Verdict;
   begin
      --  Nothing can be sent, nothing is heard; a probe fails, too

      for Later in Milliseconds range 0 .. 39 loop
         Begin_At (0);
         Assert (Next (0, 10, 0, 5_000) = Present, "before");
         Cut := Now;
         V := Present;
         while V = Present loop
            V := Next
              (0, Now + Step - Cut,
               (if Now >= Cut + Later * Step then 7 else 0), 5_000,
               Probes => (if Now >= Cut + Later * Step + 500 then 2 else 0));
            Assert (Now - Cut < 5_000, "within 5 s");
         end loop;
         Assert (V = Unreachable, "unreachable");
      end loop;
   end Test_Unreachable;

   procedure Test_Silent is
   begin
      --  Its kernel acknowledges everything

      Begin_At (0);
      for I in 1 .. 1_000 loop
         Assert (Next (0, 10, 0, Unsigned_64 (I),
                       Since_Data => Milliseconds (I) * Step) = Present,
                 "it owes nothing");
      end loop;
      for I in Milliseconds range 0 .. 2_000 loop
         Assert (Next (0, 10, 0, 1, Patience => 800, Since_Data => I)
                   = (if I > 800 then Silent else Present),
                 I'Image);
      end loop;
      Assert (Next (0, 10, 0, 1, Patience => 800, Since_Data => 0) = Present,
              "data again");

      --  Whichever is found first

      Begin_At (0);
      for I in 1 .. 41 loop
         Assert (Next (1, Milliseconds (I) * Step, 7, 1, Patience => 800,
                       Since_Data => Milliseconds (I) * Step)
                   = (if I = 41 then Vanished elsif I > 8 then Silent
                      else Present),
                 I'Image);
      end loop;
   end Test_Silent;

   procedure Test_Vanished_Idle is
      Cut  : Milliseconds;
      Sent : Milliseconds;
      V    : Verdict;
   begin
      --  The cable goes at every phase of the sampling, and something is
      --  sent at any time after that, or nothing at all: then the kernel
      --  probes it each second

      for Phase in Milliseconds range 0 .. Step - 1 loop
         for Later in Milliseconds range 0 .. 99 loop
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
                  Bytes_Acked    => 5_000,
                  Probes         =>
                    (if Now + Step > Cut + 1_000 and then Now + Step <= Sent
                     then 1 else 0));
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
         Loss     : Cause;
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
      Check (False, Present, Present, "");
      Check (True, Closed_By_Peer, Vanished, "the supervisor is stopping");
      Check (False, Closed_By_Peer, Present, "connection closed");
      Check (False, Reset_By_Peer, Stalled, "connection reset");
      Check (False, No_Sign_Of_Life, Present,
             "it vanished, no sign of life for 4 s");
      Check (False, Present, Vanished,
             "it vanished, nothing has been acknowledged for 4 s");
      Check (False, Present, Unreachable,
             "it cannot be reached, nothing could be sent for 4 s: no link, "
             & "address or route");
      Check (False, Present, Silent,
             "its program has been silent for longer than it promised (LIVE), "
             & "or --monitor-silence allows");
      Check (False, Present, Stalled, "it has taken nothing for 15 s");
   end Test_Cause;

   procedure Test_Sample is
      --  Offsets of tcpi_probes, tcpi_unacked, tcpi_last_data_recv,
      --  tcpi_last_ack_recv, tcpi_bytes_acked, tcpi_notsent_bytes and
      --  tcpi_snd_wnd
      Info : Tcp_Info :=
        (0 / 4 + 1   => 3 * 2 ** 24 + 16#0A_0B_0C#,
         24 / 4 + 1  => 2,
         52 / 4 + 1  => 40,
         56 / 4 + 1  => 30,
         120 / 4 + 1 => 5,
         124 / 4 + 1 => 1,
         144 / 4 + 1 => 100,
         228 / 4 + 1 => 2 ** 31,
         others      => 16#5555#);
      S    : Sample   := Sample_Of (Info, 232, 1_000);
   begin
      Assert (S = (Now            => 1_000,
                   Known          => True,
                   Patience       => Milliseconds'Last,
                   Unacknowledged => 2,
                   Outstanding    => 102,
                   Window         => 2 ** 31,
                   Probes         => 3,
                   Since_Heard    => 30,
                   Since_Data     => 40,
                   Bytes_Acked    => 2 ** 32 + 5),
              "all of it");
      Info (52 / 4 + 1) := 20;
      S := Sample_Of (Info, 256, 1_000);
      Assert (S.Since_Heard = 20, "data is a sign of life, too");
      S := Sample_Of (Info, 231, 1_000);
      Assert (S = (Now => 1_000, others => <>), "not enough");
   end Test_Sample;

begin
   Run_Test ("what the kernel tells", Test_Sample'Access);
   Run_Test ("nothing to say, for hours", Test_Quiet'Access);
   Run_Test ("images, acknowledged", Test_Streaming'Access);
   Run_Test ("F5: vanished, found within 5 s", Test_Vanished'Access);
   Run_Test ("F5: vanished while idle, a message follows",
             Test_Vanished_Idle'Access);
   Run_Test ("F5: cut in one direction", Test_One_Way'Access);
   Run_Test ("F5: nothing can be sent", Test_Unreachable'Access);
   Run_Test ("silent: announced signs of life do not come",
             Test_Silent'Access);
   Run_Test ("first message after a long silence", Test_After_Silence'Access);
   Run_Test ("stalled: closed window for 15 s", Test_Stalled'Access);
   Run_Test ("slow is not stalled", Test_Slow'Access);
   Run_Test ("pauses below the limit, again and again", Test_Pause'Access);
   Run_Test ("vanished goes first", Test_Both'Access);
   Run_Test ("why a session ends", Test_Cause'Access);
end Monitor_Link_Tests;
