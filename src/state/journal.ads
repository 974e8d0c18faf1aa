--  SPDX-License-Identifier: GPL-3.0-or-later
--  The log on its way to the console: a bounded buffer, so that no task ever
--  waits for the console.

with Ada.Real_Time;
with Options;
with Texts;

package Journal with SPARK_Mode is

   Capacity : constant := 256;
   --  Lines that wait for the console. A line more is not kept; how many
   --  were not is said as soon as there is room again

   type Line is record
      Level : Options.Level := Options.Info;
      Time  : Ada.Real_Time.Time := Ada.Real_Time.Time_First;
      Text  : Texts.Text;
   end record;

   procedure Set_Level (Least : Options.Level);
   --  Lines less serious than Least are not kept

   procedure Put (Level : Options.Level; Text : String);
   procedure Put (Level : Options.Level; Text : Texts.Text);
   --  One line. Characters that are no printable ASCII are shown as '?'

   procedure Take (Item : out Line);
   --  The oldest line; waits for it. For the console's task only

   procedure Get_Waiting (Count : out Natural);
   --  How many lines are not yet written

   procedure Written;
   --  The line taken last is on the console

end Journal;
