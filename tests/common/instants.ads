--  SPDX-License-Identifier: GPL-3.0-or-later
--  Times of CLOCK_MONOTONIC, which all processes of a test share: times of the
--  emulator and of the monitor can be compared.

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
