--  SPDX-License-Identifier: GPL-3.0-or-later
--  The ground of a mission: the state of robot and camera that it needs to
--  begin and to go on.

with Ada.Real_Time; use Ada.Real_Time;
with Missions.Arenas;
with Missions.Runs;
with Robot.Line_Status;
with Robot.Session;
with Vision.Mode;
with Vision.Following;
with Vision;

package Missions.Grounds with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Missions.Grounds);  --  proved

   use type Robot.Session.Mode_Kind;
   use type Vision.Mode.Stage_Kind;
   use type Vision.Arena_Corners;

   type Ground is record
      Line : Robot.Line_Status.Status;
      View : Vision.Mode.State;
      Seen : Vision.Following.Sighting;
      Now  : Time := Time_First;
   end record;
   --  What is known at the time Now

   Position_Limit : constant Time_Span :=
     Ada.Real_Time.Microseconds (Integer (Max_Age));
   --  An older position is not used: the robot may be elsewhere

   function Has_Position (G : Ground) return Boolean is
     (G.Seen.Seen and then G.Now <= G.Seen.Came + Position_Limit);

   procedure Check
     (G         : Ground;
      P         : Path;
      Size      : Arena_Size;
      Map       : out Missions.Arenas.Map;
      Targets   : out Place_Array;
      May_Begin : out Boolean;
      Why       : out Refusal)
   with
     Pre  => P.Count in Point_Number,
     Post =>
       (if May_Begin then
           Robot.Line_Status.Mode (G.Line) /= Robot.Session.Not_Started
           and then Vision.Mode.Images_Flow (G.View)
           and then G.View.Position_On
           and then G.View.Confirmed
           and then Has_Position (G)
           and then Missions.Arenas.Is_Usable (Map));
   --  Whether a mission to P may begin on G, or why not. Map is that of the
   --  arena, and Targets (1 .. P.Count) the places of the points

   function Ended_By
     (Begun, G : Ground; Is_Over, By_Hand : Boolean) return Ending
   is (if Is_Over then Session_Over
       elsif By_Hand then Missions.By_Hand
       elsif not Robot.Line_Status.Same_Run (G.Line, Begun.Line)
       then Robot_Stopped
       elsif G.View.Stage /= Vision.Mode.Streaming
         or else not G.View.Position_On
         or else not G.View.Confirmed
         or else G.View.Arena /= Begun.View.Arena
       then Camera_Ended
       else Completed);
   --  What in G ends the mission that has begun on Begun; Completed: nothing.
   --  Is_Over: its session has ended. By_Hand: an order by hand has come after
   --  the mission's

   --  Times and places as Missions.Runs has them

   Lead : constant := 1_000_000;
   --  The time at which a mission begins. Above 0, because its first image is
   --  older

   function Since (Begun, At_Time : Time) return Microseconds;
   --  Begun is at Lead. 0 if At_Time is earlier than Begun by more than Lead

   function Next_Time
     (Begun, Now : Time; Due : Microseconds) return Time;
   --  When th_mission looks next, if no image comes: Schedule.Mission_Period
   --  after Now, or at Due if that is earlier

   function Seen_From (Begun : Time; Map : Missions.Arenas.Map; G : Ground)
     return Missions.Runs.Sighting
   with Pre => Missions.Arenas.Is_Usable (Map);
   --  The newest sighting of G

end Missions.Grounds;
