--  SPDX-License-Identifier: GPL-3.0-or-later
--  The run of a mission: from what the camera has seen and what the robot has
--  been told, the next order or none.

with Robot.Session;

package Missions.Runs with SPARK_Mode is

   type Sighting is record
      Number : Natural      := 0;
      --  of the image: counts up
      Taken  : Microseconds := 0;
      --  when the image was taken
      Seen   : Boolean      := False;
      --  exactly one robot is in it
      Where  : Pose;
   end record;

   type Action_Kind is
     (Nothing,       --  wait for the next image, or Next_Look
      Ask,           --  ask the robot whether it moves
      Order,         --  a movement
      Stop,          --  the mission has ended: the robot must stop
      Leave);        --  the mission has ended, nothing more is to be done

   type Action is record
      Kind    : Action_Kind := Nothing;
      Request : Robot.Session.Request;
      --  of Ask, Order and Stop
   end record;

   type Run is private;

   procedure Start
     (R       : out Run;
      Size    : Arena_Size;
      Targets : Place_Array;
      Count   : Point_Number;
      Now     : Microseconds);

   procedure See (R : in out Run; What : Sighting);
   --  The newest image; the same one again has no effect

   procedure Step (R : in out Run; Now : Microseconds; Next : out Action);
   --  What is to be done now

   procedure Tell
     (R : in out Run; Result : Robot.Session.Outcome; Now : Microseconds);
   --  What has become of the last action (Ask, Order, Stop)

   procedure End_By (R : in out Run; Why : Abort_Reason);
   --  From outside. No effect once it has ended. By_Hand and Session_Over:
   --  the next step is Leave, others: Stop, then Leave

   function Has_Ended (R : Run) return Boolean;
   function Ended_By (R : Run) return Ending;
   function Leg (R : Run) return Point_Number;
   --  The target that is driven to
   function Legs (R : Run) return Point_Number;
   function Distance (R : Run) return Micrometres;
   --  To it, as last seen

   function Next_Look (R : Run; Now : Microseconds) return Microseconds;
   --  Step is due then even if no image comes

   function Is_Allowed (Where : Place; Size : Arena_Size) return Boolean;
   --  A target may be there: inside the arena less Target_Margin

private
   type Run is null record;
   function Has_Ended (R : Run) return Boolean is (True);
end Missions.Runs;
