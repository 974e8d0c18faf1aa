--  SPDX-License-Identifier: GPL-3.0-or-later
--  What goes wrong, on request, with an answer on its way to the wire. The
--  robot itself has heard and obeyed the command all the same.

with Interfaces;
with Robot_Core;

package Answer_Faults with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Answer_Faults);
   --  A claim that GNATprove checks: every subprogram ends

   use type Robot_Core.Octet;

   type Effect_Kind is
     (None, Silent, Dropped, Garbage, Truncated, Corrupt);

   subtype Remaining is Natural range 0 .. 1_000_000;
   --  So many answers still to be spoilt

   type Plan is record
      Silent   : Boolean   := False;  --  no answer at all, until ended
      Drop     : Remaining := 0;      --  not sent
      Garbage  : Remaining := 0;      --  random bytes instead
      Truncate : Remaining := 0;      --  without its carriage return
      Corrupt  : Remaining := 0;      --  with a wrong checksum
      Seed     : Interfaces.Unsigned_32 := 1;
   end record;
   --  Where several apply, one is used up at a time, in this order

   Max_Wire : constant := 16;

   subtype Wire_Length is Natural range 0 .. Max_Wire;

   type Wire_Bytes is record
      Length : Wire_Length := 0;
      Data   : Robot_Core.Octets (1 .. Max_Wire) := (others => 0);
   end record;

   procedure Apply
     (P      : in out Plan;
      Reply  : Robot_Core.Answer;
      Wire   : out Wire_Bytes;
      Effect : out Effect_Kind)
   with
     Post =>
       (case Effect is
           when None | Corrupt   => Wire.Length = Reply.Length,
           when Silent | Dropped => Wire.Length = 0,
           when Truncated        => Wire.Length = Reply.Length - 1,
           when Garbage          => Wire.Length > 0);
   --  What leaves instead of Reply. An empty reply stays empty and uses up
   --  nothing. Garbage never is a good frame.

end Answer_Faults;
