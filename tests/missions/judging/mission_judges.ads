--  SPDX-License-Identifier: GPL-3.0-or-later
--  Judges a mission by where the robot truly was: simulated ones and real
--  ones alike.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Mission_Plans;         use Mission_Plans;
with Robot_Motion;

package Mission_Judges is

   --  Goals

   Widest_Pass    : constant := 15.0;
   --  Millimetres from a point
   Longest_Blind  : constant Duration := 0.4;
   --  Driving without a new position
   Slowest        : constant := 1.5;
   --  To the time of an exact robot

   type Judge is private;

   procedure Start (J : out Judge; P : Plan);

   procedure See_Position (J : in out Judge; Time : Duration);
   --  A position was known from then on. Times are in order, those of the
   --  poses, too; any time may be 0

   procedure See_Pose
     (J       : in out Judge;
      Time    : Duration;
      Where   : Robot_Motion.Pose;
      Driving : Boolean);
   --  Every few milliseconds at most: what is between is not seen

   type Verdict is record
      Done      : Boolean    := False;
      --  as it says
      Reason    : Unbounded_String;
      --  what it says instead
      Time      : Duration   := 0.0;
      --  from the order to the end that it says
      Exact     : Duration   := 0.0;
      --  of an exact robot
      Passed    : Point_Count := 0;
      --  of the points, in their order
      Pass      : Long_Float := 0.0;
      --  Millimetres: the largest distance of all points passed in their
      --  order; of those that were not: from where it was nearest
      Clearance : Long_Float := 0.0;
      --  Millimetres: the least between the robot and a wall
      Blind     : Duration   := 0.0;
      --  the longest it drove without a new position
      Orders    : Natural    := 0;
      --  movements that the robot accepted
      Wrong     : Unbounded_String;
      --  what must not be; "" if nothing. It being slow is no such thing
   end record;

   function Ratio (V : Verdict) return Long_Float is
     (Long_Float (V.Time) / Long_Float (V.Exact)) with Pre => V.Exact > 0.0;

   function Is_Good (V : Verdict) return Boolean is
     (V.Done and then V.Wrong = "" and then Ratio (V) <= Slowest);
   --  It reaches all goals

   procedure Conclude
     (J      : Judge;
      P      : Plan;
      Said   : String;
      Time   : Duration;
      Orders : Natural;
      V      : out Verdict);
   --  Said: the text after "MEND:", or "" if none came

private

   type Distances is array (Point_Count) of Long_Float;

   type Judge is record
      Count     : Point_Count := 0;
      Points    : Place_Array;
      Worst     : Distances := (0 => 0.0, others => Long_Float'Last);
      --  For each K: the least that the largest distance of the points up to
      --  K can be, these being passed in their order
      Nearest   : Long_Float := Long_Float'Last;
      Last_Seen : Duration   := 0.0;
      Any_Seen  : Boolean    := False;
      Blind     : Duration   := 0.0;
      Driving   : Boolean    := False;
      --  at the end
   end record;

end Mission_Judges;
