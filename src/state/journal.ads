--  SPDX-License-Identifier: GPL-3.0-or-later
--  The log on its way to the console: a bounded buffer, so that no task ever
--  waits for the console.

with Log_Lines;
with Options;
with Texts;

package Journal with SPARK_Mode is

   Capacity : constant := Log_Lines.Capacity;
   --  Lines that wait for the console. A line more is not kept; how many
   --  were not is said as soon as there is room again

   subtype Instant is Log_Lines.Instant;

   Max_Text : constant := Log_Lines.Max_Text;
   --  Characters of a line. A longer one goes on in the next

   subtype Line is Log_Lines.Line;

   procedure Set_Level (Least : Options.Level)
   with Annotate => (GNATprove, Terminating);
   --  Lines less serious than Least are not kept

   procedure Get_Kept (Level : Options.Level; Kept : out Boolean)
   with Annotate => (GNATprove, Terminating);
   --  Whether lines of this level are: for those that take time to make

   procedure Put (Level : Options.Level; Text : String)
   with Annotate => (GNATprove, Terminating);
   procedure Put (Level : Options.Level; Text : Texts.Text)
   with Annotate => (GNATprove, Terminating);
   --  One line, or as many as it takes. Characters that are no printable
   --  ASCII are shown as '?'

   procedure Take (Item : out Line);
   --  The oldest line; waits for it. For the console's task only

   procedure Get_Waiting (Count : out Natural)
   with Annotate => (GNATprove, Terminating);
   --  How many lines are not yet written

   procedure Written with Annotate => (GNATprove, Terminating);
   --  The line taken last is on the console

end Journal;
