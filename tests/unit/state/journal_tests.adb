--  SPDX-License-Identifier: GPL-3.0-or-later
--  The journal: first in first out, the capacity, what is not kept.

with AUnit.Assertions; use AUnit.Assertions;

with Journal;
with Options;
with Texts;

package body Journal_Tests is

   subtype Any_Test is AUnit.Test_Cases.Test_Case'Class;

   procedure Check (Text : String);
   --  The oldest line.

   procedure Test_Order (T : in out Any_Test);
   procedure Test_Level (T : in out Any_Test);
   procedure Test_Full (T : in out Any_Test);
   procedure Test_Long (T : in out Any_Test);

   procedure Check (Text : String) is
      Item  : Journal.Line;
      Count : Natural;
   begin
      Journal.Get_Waiting (Count);
      Assert (Count > 0, Text & " waits");
      Journal.Take (Item);
      Assert (Item.Text (1 .. Item.Length) = Text,
              Text & " expected, not " & Item.Text (1 .. Item.Length));
      Journal.Written;
   end Check;

   overriding function Name (T : Test_Case) return AUnit.Message_String is
     (AUnit.Format ("Journal"));

   overriding procedure Register_Tests (T : in out Test_Case) is
      use AUnit.Test_Cases.Registration;
   begin
      Register_Routine (T, Test_Order'Access, "first in first out");
      Register_Routine (T, Test_Level'Access, "what is not serious enough");
      Register_Routine (T, Test_Long'Access, "a long line goes on");
      Register_Routine (T, Test_Full'Access,
                        "room for 256, then it says how many are missing");
   end Register_Tests;

   procedure Test_Full (T : in out Any_Test) is
      pragma Unreferenced (T);
      Count : Natural;
   begin
      for I in 1 .. Journal.Capacity + 3 loop
         Journal.Put (Options.Info, "line" & I'Image);
      end loop;
      Journal.Get_Waiting (Count);
      Assert (Count = Journal.Capacity, "full");
      Check ("3 lines were not kept: the console is too slow");
      for I in 1 .. Journal.Capacity loop
         Check ("line" & I'Image);
      end loop;
      Journal.Get_Waiting (Count);
      Assert (Count = 0, "empty");
   end Test_Full;

   procedure Test_Level (T : in out Any_Test) is
      pragma Unreferenced (T);
      Count : Natural;
   begin
      Journal.Put (Options.Debug, "too much");
      Journal.Get_Waiting (Count);
      Assert (Count = 0, "left out");
      Journal.Set_Level (Options.Debug);
      Journal.Put (Options.Debug, "wanted");
      Journal.Set_Level (Options.Info);
      Check ("wanted");
   end Test_Level;

   procedure Test_Long (T : in out Any_Test) is
      pragma Unreferenced (T);
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

   procedure Test_Order (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Journal.Put (Options.Info, "one");
      Journal.Put (Options.Error, "two" & ASCII.LF);
      Check ("one");
      Journal.Put (Options.Warning, Texts.To_Text ("three"));
      Check ("two?");
      Check ("three");
   end Test_Order;

end Journal_Tests;
