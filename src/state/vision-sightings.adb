--  SPDX-License-Identifier: GPL-3.0-or-later

with Event;
with Schedule;
with Trace;

package body Vision.Sightings with SPARK_Mode is

   package Searched is new Event;

   protected Store with Priority => Schedule.Sight_Ceiling is
      procedure Clear;
      procedure Put
        (Came    : Ada.Real_Time.Time;
         Robots  : Vision.Shapes.Robot_Array;
         Count   : Vision.Shapes.Robot_Count;
         Awaited : out Boolean);
      procedure Get (Newest : out Sighting);
      procedure Watch (On : Boolean);
   private
      Known   : Sighting;
      Watched : Boolean := False;
   end Store;

   protected body Store is

      procedure Clear is
      begin
         Known := (others => <>);
      end Clear;

      procedure Put
        (Came    : Ada.Real_Time.Time;
         Robots  : Vision.Shapes.Robot_Array;
         Count   : Vision.Shapes.Robot_Count;
         Awaited : out Boolean) is
      begin
         Known := Vision.Robot_Sightings.Next (Known, Came, Robots, Count);
         Awaited := Watched;
      end Put;

      procedure Get (Newest : out Sighting) is
      begin
         Newest := Known;
      end Get;

      procedure Watch (On : Boolean) is
      begin
         Watched := On;
      end Watch;

   end Store;

   procedure Clear is
   begin
      Store.Clear;
   end Clear;

   procedure Put
     (Came   : Ada.Real_Time.Time;
      Robots : Vision.Shapes.Robot_Array;
      Count  : Vision.Shapes.Robot_Count)
   is
      Awaited : Boolean;
   begin
      Store.Put (Came, Robots, Count, Awaited);
      if Awaited then
         Trace.Release (Schedule.Th_Mission);
         Searched.Set;
      end if;
   end Put;

   procedure Get (Newest : out Sighting) is
   begin
      Store.Get (Newest);
   end Get;

   procedure Watch (On : Boolean) is
   begin
      Store.Watch (On);
   end Watch;

   procedure Wait_Until (At_Time : Ada.Real_Time.Time) is
      Was_Set : Boolean;
   begin
      Trace.Done (Schedule.Th_Mission);
      Searched.Wait_Until (At_Time, Was_Set);
      if Was_Set then
         Trace.Start (Schedule.Th_Mission);
      else
         Trace.Start (Schedule.Th_Mission, At_Time);
      end if;
   end Wait_Until;

end Vision.Sightings;
