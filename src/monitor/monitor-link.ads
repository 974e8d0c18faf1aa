--  SPDX-License-Identifier: GPL-3.0-or-later
--  Detects the loss of the monitor from the kernel's data on the connection
--  (TCP_INFO), sampled a few times a second.

with Interfaces; use Interfaces;
with Texts;

package Monitor.Link with SPARK_Mode is

   type Milliseconds is range 0 .. 2 ** 62;

   Vanished_After : constant Milliseconds := 4_000;
   --  A monitor is lost that is not heard for this long, or that acknowledges
   --  nothing, though it is heard: the way to it is cut, not the way from it.
   --  With 500 ms until a battery level is sent to it, two sampling periods,
   --  and the stop, within the 5 s of F5.

   Confirmed_After : constant Milliseconds := 200;
   --  Data just sent gets the time to be acknowledged.

   Silent_After : constant Milliseconds := 800;
   --  A monitor that has announced signs of life, and shows none for this
   --  long, is lost: with a sampling period and the stop, within 1 s.

   Stalled_After : constant Milliseconds := 15_000;
   --  A monitor that accepts no data for this long is lost.

   Needed_Bytes : constant := 232;
   --  Of the kernel's struct tcp_info, up to tcpi_snd_wnd. The kernel's
   --  version decides how many it fills in: since 5.4 these; an emulated one
   --  may give 4.

   type Sample is record
      Now            : Milliseconds := 0;
      --  Monotonic time of the sample.
      Known          : Boolean      := False;
      --  The kernel has filled in the fields below.
      Patience       : Milliseconds := Milliseconds'Last;
      --  How long the monitor's program may be silent.
      Unacknowledged : Unsigned_32  := 0;
      --  Segments sent and not acknowledged (tcpi_unacked).
      Outstanding    : Unsigned_64  := 0;
      --  The same and the bytes not sent, in our kernel's queue.
      Window         : Unsigned_32  := 0;
      --  Bytes that the peer's kernel would take, as last told
      --  (tcpi_snd_wnd). 0: its program does not read.
      Probes         : Unsigned_32  := 0;
      --  Requests for an acknowledgement, without data, that are unanswered
      --  (tcpi_probes): keep-alive, or for room.
      Since_Heard    : Milliseconds := 0;
      --  Age of the last sign of life of the peer's kernel: an acknowledgement
      --  or data (tcpi_last_ack_recv, tcpi_last_data_recv). Ours requests one
      --  every second on an idle connection (keep-alive).
      Since_Data     : Milliseconds := 0;
      --  Age of the last data, which only the peer's program sends.
      Bytes_Acked    : Unsigned_64  := 0;
      --  All bytes acknowledged so far (tcpi_bytes_acked).
   end record;

   type Tcp_Info is array (1 .. Needed_Bytes / 4) of Unsigned_32
   with Convention => C;
   --  The beginning of the kernel's struct tcp_info (linux/tcp.h). Words
   --  (little-endian): 1: the probes in its last byte, 7: tcpi_unacked,
   --  14: tcpi_last_data_recv, 15: tcpi_last_ack_recv, 31 and 32:
   --  tcpi_bytes_acked, 37: tcpi_notsent_bytes, 58: tcpi_snd_wnd

   function Sample_Of
     (Info : Tcp_Info; Length : Natural; Now : Milliseconds) return Sample
   is (if Length >= Needed_Bytes then
         (Now            => Now,
          Known          => True,
          Unacknowledged => Info (7),
          Outstanding    => Unsigned_64 (Info (7)) + Unsigned_64 (Info (37)),
          Window         => Info (58),
          Probes         => Info (1) / 2 ** 24,
          Since_Heard    =>
            Milliseconds (Unsigned_32'Min (Info (14), Info (15))),
          Since_Data     => Milliseconds (Info (14)),
          Bytes_Acked    =>
            2 ** 32 * Unsigned_64 (Info (32)) + Unsigned_64 (Info (31)),
          others         => <>)
       else (Now => Now, others => <>));
   --  Length: bytes of Info that the kernel has filled in

   type Cause is
     (Present,          --  none: the session continues
      Vanished,         --  no acknowledgements: peer or route is gone
      Unreachable,      --  nothing can be sent: link or address is gone, too
      Silent,           --  its program has been silent for too long
      Stalled,          --  it acknowledges with a closed window: nobody reads
      No_Sign_Of_Life,  --  the last three as the kernel reports them
      Reset_By_Peer,
      Closed_By_Peer,
      Supervisor_Stops);
   --  Why a session ends

   subtype Verdict is Cause range Present .. Stalled;
   --  On a sample

   type State is record
      Watched_Since : Milliseconds := 0;
      --  When the connection was admitted and keep-alive began.
      Waiting       : Boolean      := False;
      --  An acknowledgement was due at the last sample ...
      Waiting_Since : Milliseconds := 0;
      --  ... since then, without any acknowledgement.
      Holding       : Boolean      := False;
      --  Bytes were outstanding at the last sample ...
      Holding_Since : Milliseconds := 0;
      --  ... since then, without any acknowledgement.
      Acked         : Unsigned_64  := 0;
      --  Bytes acknowledged at the last sample.
   end record;

   function Elapsed (Since, Now : Milliseconds) return Milliseconds is
     (if Now > Since then Now - Since else 0);

   function Has_Room (X : Sample) return Boolean is
     (X.Outstanding > 0 and then X.Window > 0);
   --  The peer, for what is outstanding. Where it has none, only its program
   --  can make room

   function Is_Due (X : Sample) return Boolean is
     (X.Probes > 0 or else Has_Room (X));
   --  An acknowledgement: the peer's kernel does not wait for its program

   --  The losses, of a sample that S already contains

   function Is_Cut (S : State; X : Sample) return Boolean is
     (S.Waiting
      and then
        (Elapsed (S.Waiting_Since, X.Now) >= Vanished_After
         or else (X.Since_Heard > Vanished_After
                  and then Elapsed (S.Watched_Since, X.Now) > Vanished_After
                  and then Elapsed (S.Waiting_Since, X.Now)
                    >= Confirmed_After)));
   --  Silence alone is no cut: with a closed window, or during a long wait for
   --  admission, the kernel may not have probed the peer for long.

   function Verdict_On (S : State; X : Sample) return Verdict is
     (if Is_Cut (S, X) then
        (if Has_Room (X) and then X.Unacknowledged = 0 then Unreachable
         else Vanished)
      elsif X.Since_Data > X.Patience then Silent
      elsif S.Holding
        and then Elapsed (S.Holding_Since, X.Now) >= Stalled_After
      then Stalled
      else Present);

   function Started (Now : Milliseconds) return State is
     (Watched_Since | Waiting_Since | Holding_Since => Now, others => <>);
   --  A connection has been admitted

   function After (S : State; X : Sample) return State is
     (Watched_Since => S.Watched_Since,
      Waiting       => Is_Due (X),
      Waiting_Since =>
        (if S.Waiting and then Is_Due (X) and then X.Bytes_Acked = S.Acked
         then S.Waiting_Since else X.Now),
      Holding       => X.Outstanding > 0,
      Holding_Since =>
        (if S.Holding and then X.Outstanding > 0
           and then X.Bytes_Acked = S.Acked
         then S.Holding_Since else X.Now),
      Acked         => X.Bytes_Acked);
   --  With one sample more

   --  What the connection itself reports

   Timed_Out : constant := 110;  --  ETIMEDOUT
   No_Route  : constant := 113;  --  EHOSTUNREACH

   function Loss_Of
     (Ended : Boolean; Broken : Boolean; Error : Integer) return Cause
   is (if not Ended then Present
       elsif Error in Timed_Out | No_Route then No_Sign_Of_Life
       elsif Broken then Reset_By_Peer
       else Closed_By_Peer);
   --  Ended: the kernel reports an end of the connection; Broken: in both
   --  directions, or an error. Error: the error of the socket (SO_ERROR), 0 if
   --  there is none

   function Cause_Of (Stopping : Boolean; Loss : Cause; V : Verdict)
     return Cause
   is (if Stopping then Supervisor_Stops elsif Loss /= Present then Loss
       else V);

   procedure Append (Line : in out Texts.Text; Why : Cause);
   --  For the log, with the time limits above

   procedure Append_Seconds (Line : in out Texts.Text; Span : Milliseconds)
   with Pre => Span <= 10 ** 9;

end Monitor.Link;
