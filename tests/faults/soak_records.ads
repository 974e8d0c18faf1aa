--  SPDX-License-Identifier: GPL-3.0-or-later
--  What a soak has measured: the supervisor each second, its answers and
--  images in the calm stretches; tables, verdict and curves of it.

with Interfaces.C;

with Instants; use Instants;

package Soak_Records is

   procedure Begin_Recording (Process : Interfaces.C.int);
   --  From now on, each second: memory, descriptors, threads. Once. What
   --  is added before does not count.

   procedure End_Recording;

   procedure Set_Calm (Value : Boolean);
   --  A session with everything and no fault: only seconds that are calm
   --  from end to end are compared

   procedure Count_Fault (Name : String);
   --  One begins

   procedure Add_Answer (Time : Instant; Latency : Duration);
   --  From a command to the supervisor's own answer, which came at Time

   procedure Add_Image (Time : Instant; Interval : Duration);
   --  An image that came at Time, Interval after the one before

   function Faults return Natural;

   procedure Print_And_Judge (Good : out Boolean);
   --  The table, first tenth against last tenth, and what is wrong with it

   procedure Write_Csv (Path : String);
   --  A line a second

   procedure Draw_Svg (Path : String; Title : String);

end Soak_Records;
