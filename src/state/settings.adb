--  SPDX-License-Identifier: GPL-3.0-or-later
--  The options of this run, shared by all tasks: set once by the main
--  procedure before it lets the server begin.

with Schedule;

package body Settings with SPARK_Mode is

   protected Store with Priority => Schedule.Settings_Ceiling is
      procedure Set (Chosen : Options.Values);
      procedure Get (Chosen : out Options.Values);
   private
      Current : Options.Values;
   end Store;

   protected body Store is

      procedure Set (Chosen : Options.Values) is
      begin
         Current := Chosen;
      end Set;

      procedure Get (Chosen : out Options.Values) is
      begin
         Chosen := Current;
      end Get;

   end Store;

   ---------
   -- Set --
   ---------

   procedure Set (Chosen : Options.Values) is
   begin
      Store.Set (Chosen);
   end Set;

   ---------
   -- Get --
   ---------

   procedure Get (Chosen : out Options.Values) is
   begin
      Store.Get (Chosen);
   end Get;

end Settings;
