--  SPDX-License-Identifier: GPL-3.0-or-later
--  Whether the monitor is still there: decided from what the kernel says
--  about the connection (TCP_INFO), sampled a few times a second.

with Texts;

package Monitor.Link with SPARK_Mode is

   type Milliseconds is range 0 .. 2 ** 62;

   type Byte_Count is range 0 .. 2 ** 63 - 1;

   Vanished_After : constant Milliseconds := 4_000;
   --  Sampled every 250 ms this finds a monitor that vanished without a
   --  packet within the 5 s of F5.

   Confirmed_After : constant Milliseconds := 200;
   --  Less than from one sample to the next: what has just been sent is to
   --  have its time to be acknowledged.

   Stalled_After : constant Milliseconds := 15_000;
   --  A monitor that takes nothing for so long is lost.

   Needed_Bytes : constant := 148;
   --  Of the kernel's struct tcp_info, up to tcpi_notsent_bytes. How many it
   --  fills in depends on its version; an emulated one may give 4.

   function Is_Enough (Length : Natural) return Boolean is
     (Length >= Needed_Bytes);
   --  Length: of what the kernel has filled in.

   type Sample is record
      Now            : Milliseconds := 0;
      --  Monotonic time of the sample.
      Known          : Boolean      := False;
      --  The kernel has said what follows.
      Unacknowledged : Natural      := 0;
      --  Segments sent and not acknowledged (tcpi_unacked).
      Since_Heard    : Milliseconds := 0;
      --  Age of the last sign of life: an acknowledgement or data
      --  (tcpi_last_ack_recv, tcpi_last_data_recv). On an idle connection
      --  the kernel asks for one every second (keep-alive).
      Outstanding    : Natural      := 0;
      --  Bytes that the monitor's machine has not taken yet: in the kernel's
      --  queue, or held by a send that does not return.
      Bytes_Acked    : Byte_Count   := 0;
      --  All bytes acknowledged so far (tcpi_bytes_acked).
   end record;

   type Verdict is
     (Present,
      Vanished,   --  nobody acknowledges: the peer or the way to it is gone
      Stalled);   --  it acknowledges, with a closed window: nobody reads

   type State is record
      Watched_Since : Milliseconds := 0;
      --  The connection was admitted, its keep-alive begun.
      Waiting       : Boolean      := False;
      --  Segments were under way at the last sample ...
      Waiting_Since : Milliseconds := 0;
      --  ... and so they were, with nothing acknowledged, since then.
      Holding       : Boolean      := False;
      --  Bytes were outstanding at the last sample ...
      Holding_Since : Milliseconds := 0;
      --  ... and so they were, with nothing acknowledged, since then.
      Acked         : Byte_Count   := 0;
      --  Bytes acknowledged at the last sample.
   end record;

   function Elapsed (Since, Now : Milliseconds) return Milliseconds is
     (if Now > Since then Now - Since else 0);

   function Is_Progress (S : State; X : Sample) return Boolean is
     (X.Bytes_Acked /= S.Acked);

   procedure Start (S : out State; Now : Milliseconds)
   with
     Post => not S.Waiting
       and then not S.Holding
       and then S.Watched_Since = Now
       and then S.Waiting_Since = Now
       and then S.Holding_Since = Now
       and then S.Acked = 0;
   --  A connection has been admitted.

   procedure Judge (S : in out State; X : Sample; V : out Verdict)
   with
     Pre  => X.Known,
     Post =>
       S.Acked = X.Bytes_Acked
       and then S.Watched_Since = S'Old.Watched_Since
       and then S.Waiting = (X.Unacknowledged > 0)
       and then S.Waiting_Since =
         (if S'Old.Waiting and then S.Waiting
            and then not Is_Progress (S'Old, X)
          then S'Old.Waiting_Since
          else X.Now)
       and then S.Holding = (X.Outstanding > 0)
       and then S.Holding_Since =
         (if S'Old.Holding and then S.Holding
            and then not Is_Progress (S'Old, X)
          then S'Old.Holding_Since
          else X.Now)
       and then V =
         (if S.Waiting
            and then X.Since_Heard > Vanished_After
            and then Elapsed (S.Watched_Since, X.Now) > Vanished_After
            and then Elapsed (S.Waiting_Since, X.Now) >= Confirmed_After
          then Vanished
          elsif S.Holding
            and then Elapsed (S.Holding_Since, X.Now) >= Stalled_After
          then Stalled
          else Present);
   --  Takes one sample. Silence alone does not make a monitor vanish: one
   --  with a closed window, or that was kept waiting before it was admitted,
   --  may not have been asked for anything for long. Nor does it count from
   --  when the oldest message went out: the keep-alive that was not answered
   --  before that is forgotten by the kernel as soon as a message follows.

   --  Why a session ends

   type Loss_Kind is (None, Closed_By_Peer, Reset_By_Peer, No_Sign_Of_Life);
   --  What the connection itself says

   type Cause is
     (Nothing, Supervisor_Stops, Monitor_Vanished, Monitor_Stalled, Silence,
      Connection_Reset, Connection_Closed);

   function Cause_Of (Stopping : Boolean; Loss : Loss_Kind; V : Verdict)
     return Cause
   is (if Stopping then Supervisor_Stops
       elsif Loss = Closed_By_Peer then Connection_Closed
       elsif Loss = Reset_By_Peer then Connection_Reset
       elsif Loss = No_Sign_Of_Life then Silence
       elsif V = Vanished then Monitor_Vanished
       elsif V = Stalled then Monitor_Stalled
       else Nothing);
   --  Nothing: the session goes on

   procedure Append (Line : in out Texts.Text; Why : Cause);
   --  For the log, with the limits above

   procedure Append_Seconds (Line : in out Texts.Text; Span : Milliseconds)
   with Pre => Span <= 10 ** 9;

end Monitor.Link;
