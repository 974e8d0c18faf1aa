--  SPDX-License-Identifier: GPL-3.0-or-later
--  The log on its way to the console: a bounded buffer, so that no task waits
--  for the console.

with Command_Lines;
with Options;

package Journal with SPARK_Mode is

   use type Options.Level;

   Capacity : constant := 256;
   --  Lines that wait for the console. Further lines are dropped; their number
   --  is logged as soon as there is room again

   Max_Text : constant := 232;
   --  Characters of a line: at most 256 bytes are copied under the lock. A
   --  longer one continues in the next line

   type Line is record
      Level   : Options.Level := Options.Info;
      At_Time : Duration := 0.0;
      --  since the supervisor started
      Length  : Natural range 0 .. Max_Text := 0;
      Text    : String (1 .. Max_Text) := (others => ' ');
   end record;

   function Is_Kept (Level : Options.Level) return Boolean is
     (Level <= Command_Lines.Given.Chosen.Log_Level);
   --  Whether this level is logged: check before making a costly line

   procedure Put (Level : Options.Level; Text : String)
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
