--  SPDX-License-Identifier: GPL-3.0-or-later

package body Robot.Health with SPARK_Mode is

   procedure Failure (H : in out State; Command : Command_Kind) is
      Owed : Class_Set := H.Owed;
   begin
      Owed (Class_Of (Command)) := True;
      H := (Failures => H.Failures + 1, Owed => Owed, Untried => False);
   end Failure;

   function Initial return State is
     ((Failures => 0, Owed => (others => False), Untried => False));

   function Opened return State is
     ((Failures => 0, Owed => (others => False), Untried => True));

   function Probe (H : State) return Command_Kind is
     (if not H.Owed (Text) then Version
      elsif not H.Owed (Digit) then Battery
      elsif not H.Owed (Unknown) then Unknown_Letter
      else Ping);

   procedure Success (H : in out State) is
   begin
      H := Initial;
   end Success;

end Robot.Health;
