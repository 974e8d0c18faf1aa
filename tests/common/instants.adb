--  SPDX-License-Identifier: GPL-3.0-or-later
--  Points in time on CLOCK_MONOTONIC.

with Ada.Strings;       use Ada.Strings;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;

with Interfaces.C;      use Interfaces.C;

with Libc;

package body Instants is

   function Now return Instant is
      Time : aliased Libc.Timespec;
   begin
      if Libc.Clock_Gettime (Libc.Clock_Monotonic, Time'Access) /= 0 then
         raise Program_Error with "no monotonic clock";
      end if;
      return Instant (Time.Seconds) * 1_000_000_000
        + Instant (Time.Nanoseconds);
   end Now;

   function "-" (Left, Right : Instant) return Duration is
      Span : constant Long_Long_Integer :=
        Long_Long_Integer (Left) - Long_Long_Integer (Right);
   begin
      return Duration'Fixed_Value (Span);
   end "-";

   function "+" (Left : Instant; Right : Duration) return Instant is
     (Left + Instant'Integer_Value (Right));

   function Milliseconds (Span : Duration) return String is
      Micro : constant Long_Long_Integer :=
        Long_Long_Integer'Integer_Value (Duration'(abs Span)) / 1000;
      Rest  : constant String :=
        Trim (Long_Long_Integer'Image (Micro mod 1000), Both);
   begin
      return (if Span < 0.0 then "-" else "")
        & Trim (Long_Long_Integer'Image (Micro / 1000), Both)
        & "." & (3 - Rest'Length) * '0' & Rest & " ms";
   end Milliseconds;

end Instants;
