--  SPDX-License-Identifier: GPL-3.0-or-later
--  Connections that nobody means to keep: what a port scanner does.

with Random_Numbers;

package Raw_Probes is

   procedure Knock
     (Address : String;
      Port    : Positive;
      Count   : Positive;
      Source  : in out Random_Numbers.Generator);
   --  Connects, and leaves at once: orderly, by a reset, before it is
   --  answered, with a few bytes, or with one direction closed only

   function Can_Half_Open return Boolean;
   --  Whether this process may write packets of its own

   procedure Half_Open
     (Address : String;
      Port    : Positive;
      Count   : Positive;
      Source  : in out Random_Numbers.Generator)
   with Pre => Can_Half_Open;
   --  The first packet of a connection, and never the third: the kernel
   --  here, which knows of no connection, answers the second by a reset

   type Crowd_Result is record
      Told   : Natural := 0;
      --  got a whole line of text before the end
      Closed : Natural := 0;
      --  came in and saw the end of their connection
      Left   : Natural := 0;
      --  neither
   end record;

   function Crowd
     (Address : String; Port : Positive; Count : Positive; Within : Duration)
      return Crowd_Result;
   --  So many connections begun before any of them is looked at

end Raw_Probes;
