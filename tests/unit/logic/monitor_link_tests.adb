--  SPDX-License-Identifier: GPL-3.0-or-later
--  The monitor's connection: present, vanished, unreachable, silent, stalled.

with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Ada.Strings.Maps;  use Ada.Strings.Maps;

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

   type Field is
     (Unacked, Heard, Outstanding, Acked, Window, Probes, Patience, Data);

   procedure Play (Script : String) is
      --  Of a connection admitted at time 0, or at N by "@N". "FIELD=N" is
      --  what the next samples say, with "FIELD=N,M" M more from one to the
      --  next; "FIELD+N" is N more. "VERDICT" is that on the next sample,
      --  "N*VERDICT" on N of them
      Value  : array (Field) of Milliseconds :=
        (Window => Milliseconds (Open), Patience => Milliseconds'Last,
         others => 0);
      Growth : array (Field) of Milliseconds := (others => 0);

      procedure Expect (Times : Positive; Wanted : Verdict) is
         Found : Verdict;
      begin
         for Number in 1 .. Times loop
            for F in Field loop
               Value (F) := Value (F) + Growth (F);
            end loop;
            Found := Next
              (Unsigned_32 (Value (Unacked)), Value (Heard),
               Unsigned_64 (Value (Outstanding)), Unsigned_64 (Value (Acked)),
               Unsigned_32 (Value (Window)), Unsigned_32 (Value (Probes)),
               Value (Patience), Value (Data));
            Assert (Found = Wanted,
                    Found'Image & ", not" & Number'Image & " times "
                    & Wanted'Image & ", after" & Now'Image & " ms of "
                    & Script);
         end loop;
      end Expect;

      procedure Carry_Out (Word : String) is
         Sign : constant Natural := Index (Word, To_Set ("=+*"));
         Name : constant String := Word (Word'First .. Sign - 1);
         Part : constant Line_Vectors.Vector :=
           Split (Word (Natural'Max (Sign, Word'First) + 1 .. Word'Last), ',');
      begin
         if Word (Word'First) = '@' then
            Begin_At (Milliseconds'Value (Part (1)));
         elsif Sign = 0 then
            Expect (1, Verdict'Value (Word));
         elsif Word (Sign) = '*' then
            Expect (Positive'Value (Name), Verdict'Value (Part (1)));
         elsif Word (Sign) = '+' then
            Value (Field'Value (Name)) :=
              Value (Field'Value (Name)) + Milliseconds'Value (Part (1));
         else
            Value (Field'Value (Name)) := Milliseconds'Value (Part (1));
            Growth (Field'Value (Name)) :=
              (if Part.Last_Index = 1 then 0
               else Milliseconds'Value (Part (2)));
         end if;
      end Carry_Out;

   begin
      Begin_At (0);
      for Word of Split (Script, ' ') loop
         Carry_Out (Word);
      end loop;
   end Play;

   procedure Check_Found
     (As          : Verdict;
      Phase       : Milliseconds;
      Least, Most : Milliseconds;
      Verdict_At  : not null access function (T : Milliseconds'Base)
                                       return Verdict)
   is
      --  The way to the monitor is cut Phase after the twentieth sample. Less
      --  than Most and more than Least later it is found: Verdict_At takes the
      --  sample T after the cut
      Cut   : Milliseconds;
      Found : Verdict;
   begin
      Begin_At (0);
      for I in 1 .. 20 loop
         Assert (Next (0, 10, 0, 5_000) = Present, "before");
      end loop;
      Cut := Now + Phase;
      loop
         Found := Verdict_At (Now + Step - Cut);
         Assert (Now - Cut < Most, "phase" & Phase'Image & ": too late");
         exit when Found /= Present;
      end loop;
      Assert (Found = As and then Now - Cut > Least,
              Found'Image & " after" & Milliseconds'Image (Now - Cut)
              & " ms, phase" & Phase'Image);
   end Check_Found;

   procedure Test_Vanished is
      --  The cable goes at every phase of the sampling; images follow each
      --  other every 100 ms, so the first unacknowledged one goes out at
      --  most 100 ms later

      function Verdict_At (T : Milliseconds'Base) return Verdict is
        (if T <= 100 then Next (0, 20, 0, 5_000)
         else Next (1, T, 40_000, 5_000));

   begin
      for Phase in Milliseconds range 0 .. Step - 1 loop
         Check_Found (Vanished, Phase, 4_000, 5_000, Verdict_At'Access);
      end loop;
   end Test_Vanished;

   procedure Test_Vanished_Idle is
      --  The cable goes at every phase of the sampling, and something is
      --  sent at any time after that, or nothing at all: then the kernel
      --  probes it each second
      Sent : Milliseconds;

      function Verdict_At (T : Milliseconds'Base) return Verdict is
        (Next (Unacknowledged => (if T > Sent then 1 else 0),
               Since_Heard    => (if T > 0 then T else 10),
               Outstanding    => (if T > Sent then 7 else 0),
               Bytes_Acked    => 5_000,
               Probes         => (if T in 1_001 .. Sent then 1 else 0)));

   begin
      for Phase in Milliseconds range 0 .. Step - 1 loop
         for Later in Milliseconds range 0 .. 99 loop
            Sent := Later * 50;
            Check_Found (Vanished, Phase, 4_000, 5_000, Verdict_At'Access);
         end loop;
      end loop;
   end Test_Vanished_Idle;

   procedure Test_One_Way is
      --  Nothing gets to it, or can be sent at all, but it is heard: at every
      --  phase of the sampling and of the battery's level. Then its window
      --  is closed, and it is only stalled
      Sent   : Milliseconds;
      Window : Unsigned_32;
      Unsent : Boolean;

      function Verdict_At (T : Milliseconds'Base) return Verdict is
        (if T <= Sent then Next (0, 20, 0, 5_000)
         else Next (Boolean'Pos (not Unsent), 20, 7, 5_000, Window));

   begin
      for Case_Number in 0 .. 3 loop
         Window := Unsigned_32 (Case_Number / 2);
         Unsent := Case_Number mod 2 = 1;
         for Phase in Milliseconds range 0 .. Step - 1 loop
            Sent := 499 - Phase;
            Check_Found ((if Window = Closed then Stalled
                          elsif Unsent then Unreachable
                          else Vanished),
                         Phase, 0,
                         (if Window = Closed then 16_000 else 4_900),
                         Verdict_At'Access);
         end loop;
      end loop;
   end Test_One_Way;

   procedure Test_Unreachable is
      --  Nothing can be sent, nothing is heard; a probe fails, too
      Later : Milliseconds;

      function Verdict_At (T : Milliseconds'Base) return Verdict is
        (Next (0, T, (if T > Later then 7 else 0), 5_000,
               Probes => (if T > Later + 500 then 2 else 0)));

   begin
      for Steps in Milliseconds range 0 .. 39 loop
         Later := Steps * Step;
         Check_Found (Unreachable, 0, 0, 5_000, Verdict_At'Access);
      end loop;
   end Test_Unreachable;

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
   begin
      Assert (Sample_Of (Info, 232, 1_000) =
                (1_000, True, Milliseconds'Last, 2, 102, 2 ** 31, 3, 30, 40,
                 2 ** 32 + 5), "all of it");
      Info (52 / 4 + 1) := 20;
      Assert (Sample_Of (Info, 256, 1_000).Since_Heard = 20,
              "data is a sign of life, too");
      Assert (Sample_Of (Info, 231, 1_000) = (Now => 1_000, others => <>),
              "not enough");
   end Test_Sample;

begin
   Run_Test ("what the kernel tells", Test_Sample'Access);
   Run_Test ("F5: vanished, found within 5 s", Test_Vanished'Access);
   Run_Test ("F5: vanished while idle, a message follows",
             Test_Vanished_Idle'Access);
   Run_Test ("F5: cut in one direction", Test_One_Way'Access);
   Run_Test ("F5: nothing can be sent", Test_Unreachable'Access);
   Run_Scripts
     (Play'Access,
      "nothing to say, for hours: @1000000 acked=1 heard=0,100 20000*Present"

      & "|images, acknowledged: unacked=3 heard=40 outstanding=60000 "
      & "acked=0,50000 10000*Present"

      --  Its kernel acknowledges everything, and it owes nothing; then it has
      --  announced signs of life. Whichever loss comes first is found
      & "|silent, announced signs of life do not come: heard=10 data=0,100 "
      & "acked=0,1 1000*Present acked=1 patience=800 data=799 Present "
      & "data=800 Present data=801 Silent data=2000 Silent data=0 Present "
      & "@0 unacked=1 outstanding=7 heard=0,100 data=0,100 8*Present "
      & "32*Silent Vanished"

      --  It was kept waiting for 20 s before it was admitted; a slow way to
      --  it, and no sign of life since, but nothing was asked of it. Then its
      --  window was closed, and the kernel's probes have become rare
      & "|first message after a long silence: unacked=1 heard=20000,100 "
      & "outstanding=7 40*Present unacked=0 heard=20 outstanding=0 acked=7 "
      & "Present window=0 heard=0,100 outstanding=9 100*Present probes=1 "
      & "Present probes=0 heard=90 Present window=64512 unacked=1 heard=190 "
      & "Present heard=10 acked=16 Present"

      --  It drops what is sent to it for want of room, and says so. The
      --  kernel's probes are acknowledged more and more rarely; while none is
      --  under way that is no sign of a peer that has gone
      & "|stalled, closed window for 15 s: @500 acked=10 heard=100 Present "
      & "heard=150 outstanding=131072 window=0 150*Present Stalled "
      & "@0 unacked=1 outstanding=9000 acked=0 150*Present Stalled "
      & "@0 unacked=0 heard=0,100 outstanding=9 150*Present heard=15000 "
      & "Stalled"

      --  A byte every 7 s, which closes the window meanwhile
      & "|slow is not stalled: unacked=1 heard=100 outstanding=100000 "
      & 28 * (35 * "window=64512 Present window=0 Present " & "acked+1 ")
      & "Present"

      & "|pauses below the limit, again and again: heard=200 outstanding=900 "
      & "window=0 " & 10 * "150*Present acked+1 " & "150*Present"

      & "|vanished goes first: heard=100 outstanding=5000 acked=9 window=0 "
      & "150*Present 20*Stalled heard=0,100 probes=1 40*Stalled Vanished");
   Run_Test ("why a session ends", Test_Cause'Access);
end Monitor_Link_Tests;
