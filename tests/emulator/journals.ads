--  SPDX-License-Identifier: GPL-3.0-or-later
--  The emulator's record of all commands: a ring buffer, allocated once.

with Answer_Faults;
with Instants;     use Instants;
with Robot_Core;

package Journals is

   Capacity : constant := 20_000;

   type Note is record
      First    : Instant := 0;
      --  When the frame's first byte reached the line (its start bit)
      Last     : Instant := 0;
      --  When the robot had all of it (the last stop bit)
      Exchange : Robot_Core.Exchange;
      Effect   : Answer_Faults.Effect_Kind := Answer_Faults.None;
      Late     : Instant := 0;
      --  Delay added to the answer
      Interval : Instant := 0;
      --  Of a reload: since the one before it, or the start
   end record;

   subtype Note_Number is Natural;
   --  Counted since the emulator started

   type Journal is limited private;

   procedure Add (J : in out Journal; N : Note);

   procedure Clear (J : in out Journal);

   procedure Find
     (J     : Journal;
      After : Note_Number;
      N     : out Note;
      Found : out Note_Number);
   --  The oldest stored note with a number above After; 0 if there is none

   function Image (N : Note) return String;
   --  One line of words, each key=value, separated by blanks:
   --
   --  first=S last=S    seconds of CLOCK_MONOTONIC, six decimals
   --  command=TEXT      without its checksum; bytes other than printable
   --                    ASCII, and blanks and backslashes, as \xHH
   --  checksum=ok|bad
   --  before=STATE after=STATE
   --  answer=TEXT       as the robot gave it, - where it gave none
   --  reload=accepted|refused interval=MS ticks=N   of a `w` only that the
   --                    robot received
   --  fault=NAME        where the answer was spoilt; lost: the command, the
   --                    robot received nothing
   --  late=MS           where it was held back

   function Image (Time : Instant) return String;
   --  Seconds with six decimals

   function Image (State : Robot_Core.State_Kind) return String;
   --  Such as watchdog_disabled

private

   type Note_Array is array (0 .. Capacity - 1) of Note;

   type Journal is limited record
      Notes   : Note_Array;
      Next    : Note_Number := 1;  --  number of the next note
      Cleared : Note_Number := 0;  --  notes up to this one are forgotten
   end record;

end Journals;
