--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time;
with Event;
with Instants;         use Instants;
with Schedule;
with Unit_Runs; use Unit_Runs;

procedure Event_Tests is

   package Asked is new Event (Schedule.Th_Arene);
   package Answered is new Event (Schedule.Th_Camera);

   procedure Test_Kept is
      Pause : constant Duration := 0.05;
      Begun : Instant;
   begin
      for I in 1 .. 3 loop
         Answered.Set;
      end loop;
      Answered.Wait;
      Begun := Now;
      declare
         task Setter;

         task body Setter is
         begin
            delay Pause;
            Answered.Set;
         end Setter;
      begin
         Answered.Wait;
      end;
      Assert (Now - Begun >= Pause, "it did not wait for the next set");
   end Test_Kept;

   procedure Test_Turns is
      Turns   : constant := 50_000;
      Counted : Natural := 0 with Atomic;
      Wrong   : Natural := 0;

      task Partner;

      task body Partner is
      begin
         for I in 1 .. Turns loop
            Asked.Wait;
            Counted := Counted + 1;
            Answered.Set;
         end loop;
      end Partner;

   begin
      for I in 1 .. Turns loop
         Asked.Set;
         Answered.Wait;
         if Counted /= I then
            Wrong := Wrong + 1;
         end if;
      end loop;
      Assert (Wrong = 0, "the partner was ahead or behind" & Wrong'Image
              & " times");
   end Test_Turns;

   procedure Test_Until is
      use Ada.Real_Time;
      Pause   : constant Time_Span := Milliseconds (30);
      Begun   : Time;
      Was_Set : Boolean;
   begin
      Begun := Clock;
      Answered.Wait_Until (Begun + Pause, Was_Set);
      Assert (not Was_Set, "set by nobody");
      Assert (Clock - Begun >= Pause, "the wait ended too soon");

      Answered.Set;
      Begun := Clock;
      Answered.Wait_Until (Begun + Seconds (5), Was_Set);
      Assert (Was_Set and then Clock - Begun < Seconds (1),
              "a set before the wait does not end it");

      declare
         task Setter;

         task body Setter is
         begin
            delay until Begun + Pause;
            Answered.Set;
         end Setter;
      begin
         Answered.Wait_Until (Begun + Seconds (5), Was_Set);
      end;
      Assert (Was_Set and then Clock - Begun < Seconds (1),
              "a set during the wait does not end it");

      --  with a time that is over it only looks

      Answered.Wait_Until (Time_First, Was_Set);
      Assert (not Was_Set, "one set, taken twice");
      Answered.Set;
      Answered.Wait_Until (Time_First, Was_Set);
      Assert (Was_Set, "not taken as the time is over");

      --  and one that never comes is none

      Answered.Set;
      Answered.Wait_Until (Time_Last, Was_Set);
      Assert (Was_Set, "not taken as there is no end");
   end Test_Until;

begin
   Run_Test ("several sets count as one, then it blocks", Test_Kept'Access);
   Run_Test ("two tasks wake each other, none is lost", Test_Turns'Access);
   Run_Test ("a wait ends with the event or at its time", Test_Until'Access);
end Event_Tests;
