--  SPDX-License-Identifier: GPL-3.0-or-later

with AUnit.Assertions; use AUnit.Assertions;

with Ada.Real_Time;    use Ada.Real_Time;
with Vision.Following;
with Vision.Shapes;    use Vision.Shapes;
with Vision.Sightings; use Vision.Sightings;
with Unit_Runs; use Unit_Runs;

procedure Vision_Sightings_Tests is

   Two : constant Robot_Array :=
     (1 => (Id => 7, Centre => (1, 2), Direction => (3, 4), Angle => 5),
      2 => (Id => 8, others => <>),
      others => <>);

   procedure Check (Number : Natural; Seen : Boolean; What : String) is
      Now : Vision.Following.Sighting;
   begin
      Store.Get (Now);
      Assert (Now.Number = Number, What & ": number" & Now.Number'Image);
      Assert (Now.Seen = Seen, What & ": seen " & Now.Seen'Image);
      if Seen then
         Assert (Now.Robot = Two (1), What & ": another robot");
      end if;
   end Check;

   procedure Test_Seen is
      Came : constant Time := Clock;
      Now  : Vision.Following.Sighting;
   begin
      Store.Clear;
      Check (0, False, "nothing yet");
      Put (Came, Two, 1);
      Check (1, True, "one robot");
      Store.Get (Now);
      Assert (Now.Came = Came, "time of the image");
      Put (Came, Two, 0);
      Check (2, False, "none");
      Put (Came, Two, 2);
      Check (3, False, "two");
      Put (Came, Two, 1);
      Check (4, True, "one again");
      Store.Clear;
      Check (0, False, "closed");
   end Test_Seen;

   procedure Test_Wake is
      Pause : constant Time_Span := Milliseconds (30);
      Begun : Time;
   begin
      Store.Clear;
      Put (Clock, Two, 1);
      Begun := Clock;
      Wait_Until (Begun + Pause);
      Assert (Clock - Begun >= Pause, "woken, but nobody watches");

      Store.Watch (True);
      Put (Clock, Two, 1);
      Begun := Clock;
      Wait_Until (Begun + Seconds (5));
      Assert (Clock - Begun < Seconds (1), "not woken by an image");
      Store.Watch (False);
      Store.Clear;
   end Test_Wake;

begin
   Run_Test ("exactly one robot is a sighting, others are counted",
             Test_Seen'Access);
   Run_Test ("wakes the task that watches, and only that", Test_Wake'Access);
end Vision_Sightings_Tests;
