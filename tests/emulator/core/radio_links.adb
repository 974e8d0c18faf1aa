--  SPDX-License-Identifier: GPL-3.0-or-later
--  One direction of a pair of radios: repeatable, by the link's own seed.

with Answer_Faults;
with Robot_Core;

package body Radio_Links with SPARK_Mode is

   use Interfaces;

   subtype Share is Natural range 0 .. 65_535;

   procedure Draw (Seed : in out Unsigned_32; Value : out Share) is
      High, Low : Robot_Core.Octet;
   begin
      Answer_Faults.Draw (Seed, High);
      Answer_Faults.Draw (Seed, Low);
      Value := Natural (High) * 256 + Natural (Low);
   end Draw;

   procedure Draw
     (Seed : in out Unsigned_32; Chance : Percent; Hit : out Boolean)
   with Post => (if Chance = 0 then not Hit elsif Chance = 100 then Hit)
   is
      Value : Share;
   begin
      Draw (Seed, Value);
      Hit := Value * 100 < Chance * 65_536;
   end Draw;

   procedure Gather (L : in out Link; Ended : Time_Point) is
   begin
      L.Length := L.Length + 1;
      L.Last   := Ended;
   end Gather;

   procedure Send
     (L       : in out Link;
      C       : Chances;
      Closed  : Time_Point;
      Arrival : out Time;
      Lost    : out Boolean)
   is
      Retries : Natural range 0 .. Max_Retries := 0;
      Again   : Boolean;
      Value   : Share;
      Chance  : Percent := C.Retries;
   begin
      if C.Bursts = 0 then
         L.Left := 0;
      elsif L.Left > 0 then
         L.Left := L.Left - 1;
      else
         Draw (L.Seed, C.Bursts, Again);
         L.Left := (if Again then Burst else 0);
      end if;
      if L.Left > 0 then
         Chance := Percent'Max (Chance, 50);
      end if;
      while Retries < Max_Retries loop
         pragma Loop_Variant (Increases => Retries);
         pragma Loop_Invariant (if Chance = 0 then Retries = 0);
         Draw (L.Seed, Chance, Again);
         exit when not Again;
         Retries := Retries + 1;
      end loop;
      Draw (L.Seed, Value);
      Arrival := Time'Max (Closed, L.Free) + Shortest_Air
        + (Longest_Air - Shortest_Air) * Time (Value) / Time (Share'Last)
        + Retry_Time * Time (Retries);
      Draw (L.Seed, C.Losses, Lost);
      L.Length := 0;
      L.Free   := Arrival;
   end Send;

end Radio_Links;
