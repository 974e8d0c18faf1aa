--  SPDX-License-Identifier: GPL-3.0-or-later

with Event;
with Trace;

package body Vision.Sightings with SPARK_Mode is

   package Searched is new Event;

   protected body Store is

      procedure Clear is
      begin
         Known := (others => <>);
      end Clear;

      procedure Put
        (Came    : Time;
         Robots  : Vision.Shapes.Robot_Array;
         Count   : Vision.Shapes.Robot_Count;
         Awaited : out Boolean) is
      begin
         Known := Vision.Following.Next (Known, Came, Robots, Count);
         Awaited := Watched;
      end Put;

      procedure Get (Newest : out Vision.Following.Sighting) is
      begin
         Newest := Known;
      end Get;

      procedure Watch (On : Boolean) is
      begin
         Watched := On;
      end Watch;

   end Store;

   procedure Put
     (Came   : Time;
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

   procedure Wait_Until (At_Time : Time) is
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
