--  SPDX-License-Identifier: GPL-3.0-or-later
--  The log on its way to the console: a bounded buffer, so that no task waits
--  for the console.

with Log_Lines;
with Options;
with Texts;

package Journal with SPARK_Mode is

   Capacity : constant := Log_Lines.Capacity;
   --  Lines that wait for the console. Further lines are dropped; their number
   --  is logged as soon as there is room again

   subtype Instant is Log_Lines.Instant;

   Max_Text : constant := Log_Lines.Max_Text;
   --  Characters of a line. A longer one continues in the next line

   subtype Line is Log_Lines.Line;

   procedure Set_Level (Least : Options.Level)
   with Annotate => (GNATprove, Terminating);
   --  Lines less serious than Least are not logged

   procedure Get_Kept (Level : Options.Level; Kept : out Boolean)
   with Annotate => (GNATprove, Terminating);
   --  Whether this level is logged: check before making a costly line

   procedure Put (Level : Options.Level; Text : String)
   with Annotate => (GNATprove, Terminating);
   procedure Put (Level : Options.Level; Text : Texts.Text)
   with Annotate => (GNATprove, Terminating);
   --  One line, or as many as the text needs. Characters other than printable
   --  ASCII are shown as '?'

   procedure Take (Item : out Line);
   --  The oldest line; waits for it. For the console's task only

   procedure Get_Waiting (Count : out Natural)
   with Annotate => (GNATprove, Terminating);
   --  Number of lines not yet written

   procedure Written with Annotate => (GNATprove, Terminating);
   --  The line taken last is on the console

end Journal;
