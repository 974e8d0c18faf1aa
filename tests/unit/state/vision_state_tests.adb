--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time;    use Ada.Real_Time;
with Vision.Following;
with Vision;           use Vision;
with Vision.State;     use Vision.State;
with Unit_Runs; use Unit_Runs;

procedure Vision_State_Tests is

   Two : constant Robot_Array :=
     (1 => (Id => 7, Centre => (1, 2), Direction => (3, 4), Angle => 5),
      2 => (Id => 8, others => <>),
      others => <>);

   procedure Reopen is
      --  The camera
      Ignored : Boolean;
   begin
      Store.Report (True);
      Store.Opened (1, Ignored);
   end Reopen;

   procedure Check (Number : Natural; Seen : Boolean; What : String) is
      Now : Vision.Following.Sighting;
   begin
      Store.Get_Sighting (Now);
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
      Reopen;
      Check (0, False, "nothing yet");
      Put (Came, Two, 1);
      Check (1, True, "one robot");
      Store.Get_Sighting (Now);
      Assert (Now.Came = Came, "time of the image");
      Put (Came, Two, 0);
      Check (2, False, "none");
      Put (Came, Two, 2);
      Check (3, False, "two");
      Put (Came, Two, 1);
      Check (4, True, "one again");
      Reopen;
      Check (0, False, "opened again");
   end Test_Seen;

   procedure Test_Wake is
      Pause : constant Time_Span := Milliseconds (30);
      Begun : Time;
   begin
      Put (Clock, Two, 1);
      Begun := Clock;
      Wait_Sighting (Begun + Pause);
      Assert (Clock - Begun >= Pause, "woken, but nobody watches");

      Store.Watch (True);
      Put (Clock, Two, 1);
      Begun := Clock;
      Wait_Sighting (Begun + Seconds (5));
      Assert (Clock - Begun < Seconds (1), "not woken by an image");
      Store.Watch (False);
   end Test_Wake;

begin
   Run_Test ("exactly one robot is a sighting, others are counted",
             Test_Seen'Access);
   Run_Test ("wakes the task that watches, and only that", Test_Wake'Access);
end Vision_State_Tests;
