--  SPDX-License-Identifier: GPL-3.0-or-later

with Schedule;

package body Missions.Grounds with SPARK_Mode is

   procedure Check
     (G         : Ground;
      P         : Path;
      Size      : Arena_Size;
      Map       : out Missions.Arenas.Map;
      Targets   : out Place_Array;
      May_Begin : out Boolean;
      Why       : out Refusal)
   is
      Usable : Boolean;
      Inside : Boolean;
   begin
      Missions.Arenas.Make (G.View.Arena, Size, Map, Usable);
      Targets := (others => <>);
      May_Begin := False;
      if Robot.Line_Status.Mode (G.Line) = Robot.Session.Not_Started then
         Why := Robot_Not_Started;
      elsif not Vision.Mode.Is_Open (G.View) then
         Why := Camera_Closed;
      elsif not G.View.Position_On then
         Why := Positions_Off;
      elsif not G.View.Confirmed
        or else not Vision.Mode.Images_Flow (G.View)
      then
         Why := Arena_Not_Confirmed;
      elsif not Usable then
         Why := Arena_Too_Small;
      elsif not Has_Position (G) then
         Why := Robot_Not_Seen;
      else
         Missions.Arenas.Targets (P, Map, Size, Targets, Inside);
         May_Begin := Inside;
         Why := Point_Outside;
      end if;
   end Check;

   function Since (Begun, At_Time : Time) return Microseconds is
      First : constant Time := Begun - Seconds (1);
      --  Lead before Begun
      Span  : Time_Span;
      Whole : Integer;
      Rest  : Integer;
   begin
      if At_Time <= First then
         return 0;
      end if;
      --  in two parts: an Integer of microseconds is 35 minutes at most
      Span := At_Time - First;
      Whole := Span / Seconds (1);
      Rest := (Span - Seconds (Whole)) / Ada.Real_Time.Microseconds (1);
      return Microseconds (Integer'Max (0, Whole)) * 1_000_000
        + Microseconds (Integer'Max (0, Rest));
   end Since;

   function Next_Time
     (Begun, Now : Time; Due : Microseconds) return Time
   is
      Present : constant Microseconds := Since (Begun, Now);
      Left    : constant Microseconds := Microseconds'Min
        (1_000_000, Microseconds'Max (Due, Present) - Present);
      Span    : constant Time_Span :=
        Ada.Real_Time.Microseconds (Integer (Left));
   begin
      return Now
        + (if Span < Schedule.Mission_Period then Span
           else Schedule.Mission_Period);
   end Next_Time;

   function Seen_From (Begun : Time; Map : Missions.Arenas.Map; G : Ground)
     return Missions.Runs.Sighting
   is
      Result : Missions.Runs.Sighting :=
        (Number => G.Seen.Number,
         Taken  => Since (Begun, G.Seen.Came),
         Seen   => False,
         Where  => (others => <>));
   begin
      if G.Seen.Seen then
         Missions.Arenas.Locate
           (Map, G.Seen.Robot, Result.Where, Result.Seen);
      end if;
      return Result;
   end Seen_From;

end Missions.Grounds;
