--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the kernel tells of a TCP socket (TCP_INFO), and what it means for the
--  monitor's connection.

with Interfaces;
with Monitor.Link;

package Monitor.Tcp_Infos with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Monitor.Tcp_Infos);

   use type Interfaces.Unsigned_32;
   use type Interfaces.Unsigned_64;
   use type Monitor.Link.Milliseconds;

   type Word_Array is array (Positive range <>) of Interfaces.Unsigned_32
     with Convention => C;

   type Tcp_Info is record
      State       : Interfaces.Unsigned_8  := 0;
      Congestion  : Interfaces.Unsigned_8  := 0;
      Retransmits : Interfaces.Unsigned_8  := 0;
      Probes      : Interfaces.Unsigned_8  := 0;
      --  Unanswered
      Times       : Word_Array (1 .. 5)    := (others => 0);
      --  Options, times, segment sizes
      Unacked     : Interfaces.Unsigned_32 := 0;
      --  Segments
      Counters    : Word_Array (1 .. 6)    := (others => 0);
      --  Up to the age of the last one sent
      Last_Data   : Interfaces.Unsigned_32 := 0;
      --  Milliseconds since data was received
      Last_Ack    : Interfaces.Unsigned_32 := 0;
      --  Milliseconds since an acknowledgement was received
      Metrics     : Word_Array (1 .. 11)   := (others => 0);
      Pacing      : Word_Array (1 .. 4)    := (others => 0);
      Bytes_Acked : Interfaces.Unsigned_64 := 0;
      Bytes_Got   : Interfaces.Unsigned_64 := 0;
      Segments    : Word_Array (1 .. 2)    := (others => 0);
      Not_Sent    : Interfaces.Unsigned_32 := 0;
      --  Bytes
      Later       : Word_Array (1 .. 20)   := (others => 0);
      --  Times, rates, counters
      Window      : Interfaces.Unsigned_32 := 0;
      --  Bytes that the peer takes, as last told
   end record
   with Convention => C, Size => 232 * 8;
   --  The beginning of the kernel's struct tcp_info (linux/tcp.h)

   function To_Natural (Value : Interfaces.Unsigned_64) return Natural is
     (Natural
        (Interfaces.Unsigned_64'Min
           (Value, Interfaces.Unsigned_64 (Natural'Last))));

   function Sample_Of
     (Info : Tcp_Info; Length : Natural; Now : Monitor.Link.Milliseconds)
      return Monitor.Link.Sample
   is (if Monitor.Link.Is_Enough (Length) then
         (Now            => Now,
          Known          => True,
          Unacknowledged =>
            To_Natural (Interfaces.Unsigned_64 (Info.Unacked)),
          Outstanding    =>
            To_Natural (Interfaces.Unsigned_64 (Info.Not_Sent)
                        + Interfaces.Unsigned_64 (Info.Unacked)),
          Window         => To_Natural (Interfaces.Unsigned_64 (Info.Window)),
          Probes         => Natural (Info.Probes),
          Since_Heard    => Monitor.Link.Milliseconds
            (Interfaces.Unsigned_32'Min (Info.Last_Ack, Info.Last_Data)),
          Since_Data     => Monitor.Link.Milliseconds (Info.Last_Data),
          Bytes_Acked    => Monitor.Link.Byte_Count
            (Info.Bytes_Acked and (2 ** 63 - 1)),
          others         => <>)
       else (Now => Now, others => <>))
   with
     Post => Sample_Of'Result.Now = Now
       and then Sample_Of'Result.Known = Monitor.Link.Is_Enough (Length)
       and then
         (if Sample_Of'Result.Known then
             (Sample_Of'Result.Unacknowledged > 0) = (Info.Unacked > 0)
             and then (Sample_Of'Result.Outstanding > 0)
               = (Info.Unacked > 0 or else Info.Not_Sent > 0)
             and then (Sample_Of'Result.Window > 0) = (Info.Window > 0)
             and then Sample_Of'Result.Probes = Natural (Info.Probes));
   --  Length: bytes of Info that the kernel has filled in

end Monitor.Tcp_Infos;
