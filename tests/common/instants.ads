--  SPDX-License-Identifier: GPL-3.0-or-later
--  Points in time on CLOCK_MONOTONIC, which every process of a test shares:
--  what the emulator notes can be compared with what the monitor received.

package Instants is

   type Instant is new Long_Long_Integer;
   --  Nanoseconds of CLOCK_MONOTONIC

   Never : constant Instant := 0;

   function Now return Instant;

   function "-" (Left, Right : Instant) return Duration;
   function "+" (Left : Instant; Right : Duration) return Instant;

   function Milliseconds (Span : Duration) return String;
   --  "12.345 ms", for messages

end Instants;
