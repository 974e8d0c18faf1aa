--  SPDX-License-Identifier: GPL-3.0-or-later
--  Short-lived connections, as from a port scanner.

with Random_Numbers;

package Raw_Probes is

   procedure Knock
     (Address : String;
      Port    : Positive;
      Count   : Positive;
      Source  : in out Random_Numbers.Generator);
   --  Connects and disconnects at once: in order, by a reset, before the
   --  answer, after a few bytes, or with one direction closed

   function Can_Half_Open return Boolean;
   --  Whether this process may send raw packets

   procedure Half_Open
     (Address : String;
      Port    : Positive;
      Count   : Positive;
      Source  : in out Random_Numbers.Generator)
   with Pre => Can_Half_Open;
   --  The first packet of a handshake, and never the third: the kernel here,
   --  which knows no such connection, answers the second by a reset

   type Crowd_Result is record
      Told   : Natural := 0;
      --  received a complete line before the end
      Closed : Natural := 0;
      --  were accepted, and then closed
      Left   : Natural := 0;
      --  neither
   end record;

   function Crowd
     (Address : String; Port : Positive; Count : Positive; Within : Duration)
      return Crowd_Result;
   --  Starts so many connections before checking any

end Raw_Probes;
