--  SPDX-License-Identifier: GPL-3.0-or-later
--  One direction of a pair of radios (XBee, transparent): bytes of a wire are
--  gathered to a packet, which is in the air for a while, is lost or arrives.

with Interfaces;

package Radio_Links with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Radio_Links);
   --  A claim that GNATprove checks: every subprogram ends

   type Time is range 0 .. 2 ** 62;
   --  Nanoseconds

   subtype Time_Point is Time range 0 .. 2 ** 61;

   subtype Byte_Time is Time range 0 .. 10_000_000_000;
   --  Of a byte on the wire

   Silence      : constant := 3;    --  byte times that end a packet (RO)
   Max_Packet   : constant := 100;  --  bytes, of an XBee 802.15.4
   --  In the air, as modelled with the real firmware:
   Shortest_Air : constant := 5_000_000;
   Longest_Air  : constant := 12_000_000;
   Retry_Time   : constant := 30_000_000;
   Max_Retries  : constant := 8;    --  of a packet
   Burst        : constant := 8;    --  packets

   subtype Burst_Count is Natural range 0 .. Burst;

   subtype Percent is Natural range 0 .. 100;

   type Chances is record
      Retries : Percent := 2;  --  of all attempts, independent of each other
      Bursts  : Percent := 0;
      --  of all packets; half of all attempts are repeated from such a one on,
      --  for Burst
      Losses  : Percent := 0;  --  of all packets
   end record;

   subtype Packet_Length is Natural range 0 .. Max_Packet;

   type Link is record
      Seed   : Interfaces.Unsigned_32 := 1;
      Length : Packet_Length := 0;  --  bytes gathered
      Last   : Time_Point := 0;     --  end of the last of them
      Free   : Time := 0;           --  end of the last packet in the air
      Left   : Burst_Count := 0;    --  packets in the burst, the last included
   end record;

   function Closing (L : Link; Each : Byte_Time) return Time is
     (if L.Length = Max_Packet then L.Last else L.Last + Silence * Each);
   --  When the packet is complete unless another byte ends before. Each: of
   --  the bytes.

   function Joins (L : Link; Ended : Time_Point; Each : Byte_Time)
     return Boolean
   is (L.Length = 0
       or else (L.Length < Max_Packet and then Ended <= Closing (L, Each)));
   --  The next byte, which ends then, is of the same packet

   procedure Gather (L : in out Link; Ended : Time_Point)
     with Pre  => L.Length < Max_Packet,
          Post => L.Length = L.Length'Old + 1 and then L.Last = Ended
                  and then L.Free = L.Free'Old;
   --  A byte

   procedure Send
     (L       : in out Link;
      C       : Chances;
      Closed  : Time_Point;
      Arrival : out Time;
      Lost    : out Boolean)
   with
     Pre  => L.Free in Time_Point,
     Post => L.Length = 0 and then L.Free = Arrival
             and then Arrival - Time'Max (Closed, L.Free'Old)
                      in Shortest_Air
                      .. Longest_Air + (if C.Retries + C.Bursts = 0 then 0
                                        else Max_Retries * Retry_Time)
             and then (if C.Losses = 0 then not Lost)
             and then (if C.Losses = 100 then Lost);
   --  The packet, after those before it

end Radio_Links;
