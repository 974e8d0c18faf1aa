--  SPDX-License-Identifier: GPL-3.0-or-later
--  The log on its way to the console: a bounded buffer, so that no task waits
--  for the console.

with Options;
with Texts;

package Journal with SPARK_Mode is

   Capacity : constant := 256;
   --  Lines that wait for the console. Further lines are dropped; their number
   --  is logged as soon as there is room again

   Max_Text : constant := 232;
   --  Characters of a line: at most 256 bytes are copied under the lock. A
   --  longer one continues in the next line

   type Instant is record
      Seconds     : Natural := 0;
      Thousandths : Natural range 0 .. 999 := 0;
   end record;
   --  The time since the supervisor started

   type Line is record
      Level  : Options.Level := Options.Info;
      Time   : Instant;
      Length : Natural range 0 .. Max_Text := 0;
      Text   : String (1 .. Max_Text) := (others => ' ');
   end record;

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
   --  The oldest line; waits for it. The one taken before is on the console.
   --  For the console's task only

   procedure Get_Waiting (Count : out Natural)
   with Annotate => (GNATprove, Terminating);
   --  Number of lines that are not yet on the console

end Journal;
