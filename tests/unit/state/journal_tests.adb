--  SPDX-License-Identifier: GPL-3.0-or-later
--  The journal: first in first out, the capacity, what is not kept.

with Command_Lines;
with Journal;
with Options;
with Unit_Runs; use Unit_Runs;

procedure Journal_Tests is

   procedure Check (Text : String) is
      --  The oldest line.
      Item  : Journal.Line;
      Count : Natural;
   begin
      Journal.Get_Waiting (Count);
      Assert (Count > 0, Text & " waits");
      Journal.Take (Item);
      Assert (Item.Text (1 .. Item.Length) = Text,
              Text & " expected, not " & Item.Text (1 .. Item.Length));
   end Check;

   procedure Test_Full is
      Count : Natural;
      --  with the line that Check has taken last
   begin
      for I in 1 .. Journal.Capacity + 3 loop
         Journal.Put (Options.Info, "line" & I'Image);
      end loop;
      Journal.Get_Waiting (Count);
      Assert (Count = Journal.Capacity + 1, "full");
      Check ("3 lines were not kept: the console is too slow");
      for I in 1 .. Journal.Capacity loop
         Check ("line" & I'Image);
      end loop;
      Journal.Get_Waiting (Count);
      Assert (Count = 1, "empty");
   end Test_Full;

   procedure Test_Level is
      Before : Natural;
      Count  : Natural;
   begin
      Journal.Get_Waiting (Before);
      Journal.Put (Options.Debug, "too much");
      Journal.Get_Waiting (Count);
      Assert (Count = Before, "left out");
      Command_Lines.Given.Chosen.Log_Level := Options.Debug;
      Journal.Put (Options.Debug, "wanted");
      Command_Lines.Given.Chosen.Log_Level := Options.Info;
      Check ("wanted");
   end Test_Level;

   procedure Test_Long is
      Full : constant String (1 .. Journal.Max_Text) := (others => 'f');
   begin
      Journal.Put (Options.Info, Full & Full & "!");
      Journal.Put (Options.Info, Full);
      Journal.Put (Options.Info, "");
      Check (Full);
      Check (Full);
      Check ("!");
      Check (Full);
      Check ("");
   end Test_Long;

   procedure Test_Order is
   begin
      Journal.Put (Options.Info, "one");
      Journal.Put (Options.Error, "two" & ASCII.LF);
      Check ("one");
      Journal.Put (Options.Warning, "three");
      Check ("two?");
      Check ("three");
   end Test_Order;

begin
   Run_Test ("first in first out", Test_Order'Access);
   Run_Test ("what is not serious enough", Test_Level'Access);
   Run_Test ("a long line goes on", Test_Long'Access);
   Run_Test ("room for 256, then it says how many are missing",
             Test_Full'Access);
end Journal_Tests;
