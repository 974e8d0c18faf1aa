--  SPDX-License-Identifier: GPL-3.0-or-later
--  The serial line's task: bytes between the pseudo-terminal and the robot,
--  each at its time.
--
--  At B baud a byte takes 10 / B seconds (start bit, 8 bits, stop bit). The
--  robot has heard a byte when its time is over, and a client reads an
--  answer's byte when that one's time is over. Times are absolute: a byte
--  that is late does not make the next one late.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Robot_Core;

package Serial_Side is

   subtype Baud_Rate is Natural range 0 .. 4_000_000;
   --  0: bytes take no time

   procedure Start
     (Baud : Baud_Rate; Link : String; Problem : out Unbounded_String);
   --  Makes the device, and the link unless that is "", and begins. Once.
   --  Problem says why it could not; "" if it could.

   procedure Stop;
   --  Hangs up and removes the link. After Start only.

   function Device return String;
   --  The pseudo-terminal; "-" while hung up

   --  Each of the following returns when it has happened: "" when done,
   --  else what is wrong.

   function Send_Unasked (Data : Robot_Core.Octets) return String
     with Pre => Data'Length <= 256;
   --  Puts bytes on the line that nobody asked for, behind what is there

   function Hang_Up return String;
   --  The device and its link go away. The robot hears nothing any more.

   function Put_Back return String;
   --  A new device; the link points to it

end Serial_Side;
