--  SPDX-License-Identifier: GPL-3.0-or-later
--  The measurements of a soak test: the supervisor each second, answers and
--  images in calm periods; table and verdict.

with Interfaces.C;

with Instants; use Instants;

package Soak_Records is

   procedure Begin_Recording (Process : Interfaces.C.int);
   --  Starts sampling each second: memory, descriptors, threads. Call once.
   --  Data added before is ignored.

   procedure End_Recording;

   procedure Set_Calm (Value : Boolean);
   --  A session with all features and no fault: only completely calm seconds
   --  are compared

   procedure Count_Fault (Name : String);
   --  One begins

   procedure Add_Answer (Time : Instant; Latency : Duration);
   --  From a command to the supervisor's own answer, received at Time

   procedure Add_Image (Time : Instant; Interval : Duration);
   --  An image received at Time, Interval after the one before

   function Faults return Natural;

   procedure Print_And_Judge (Good : out Boolean);
   --  The table, first tenth against last tenth, and its violations

   procedure Write_Csv (Path : String);
   --  One line per second, which tests/bench/plots.py draws

end Soak_Records;
