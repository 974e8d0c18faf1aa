--  SPDX-License-Identifier: GPL-3.0-or-later
--  The log on its way to the console: a bounded buffer, so that no task ever
--  waits for the console.

with Options;
with Texts;

package Journal with SPARK_Mode is

   Capacity : constant := 256;
   --  Lines that wait for the console. A line more is not kept; how many
   --  were not is said as soon as there is room again

   type Instant is record
      Seconds     : Natural := 0;
      Thousandths : Natural range 0 .. 999 := 0;
   end record;
   --  The time since the supervisor started

   Max_Text : constant := 232;
   --  Characters of a line: no more than 256 bytes are copied under the lock.
   --  A longer one goes on in the next

   subtype Text_Length is Natural range 0 .. Max_Text;

   type Line is record
      Level  : Options.Level := Options.Info;
      Time   : Instant;
      Length : Text_Length := 0;
      Text   : String (1 .. Max_Text) := (others => ' ');
   end record;

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
