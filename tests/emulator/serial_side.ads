--  SPDX-License-Identifier: GPL-3.0-or-later
--  The serial line's task: transfers bytes between the pseudo-terminal and the
--  robot, with the timing of the line.
--
--  At B baud a byte takes 10 / B seconds (start bit, 8 bits, stop bit). The
--  robot receives a byte at the end of its time, and a client reads a byte of
--  an answer at the end of its time. Times are absolute: a delayed byte does
--  not delay the next one.
--
--  With radios there are two wires in each direction, and Radio_Links between
--  them.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Robot_Core;

package Serial_Side is

   subtype Baud_Rate is Natural range 0 .. 4_000_000;
   --  0: bytes take no time

   type Choice is record
      Link   : Unbounded_String;        --  "": none
      Socket : Boolean := False;        --  at Link, no pseudo-terminal
      Baud   : Baud_Rate := 9_600;
      Radio  : Boolean := False;
      Seed   : Natural := 1;            --  of the radios
   end record;

   procedure Start (Chosen : Choice; Problem : out Unbounded_String);
   --  Creates the device, or the socket, and starts. A byte that it sends over
   --  20 ms late is told on standard error: "late by N ms". Call once.
   --  Problem is the reason of a failure; "" if none.

   procedure Stop;
   --  Hangs up and removes the link. After Start only.

   type Request_Kind is
     (Send,         --  unsolicited bytes, after those already waiting
      Hang,         --  device and link go: the robot receives nothing more
      Return_Line,  --  a new device; the link points to it
      Name,         --  of the pseudo-terminal, "-" while hung up
      Finish);      --  see Stop

   function Ask
     (Kind : Request_Kind; Data : Robot_Core.Octets := (1 .. 0 => 0))
      return String
   with Pre => Data'Length <= 256;
   --  Returns when it is done: "", the name, or the error

end Serial_Side;
