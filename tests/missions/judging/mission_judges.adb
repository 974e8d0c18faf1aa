--  SPDX-License-Identifier: GPL-3.0-or-later
--  Judges missions.

with Ada.Numerics.Long_Elementary_Functions;
use Ada.Numerics.Long_Elementary_Functions;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;

with Plain_Numbers;     use Plain_Numbers;

package body Mission_Judges is

   use type Micro;

   Touch : constant := 0.1;
   --  Millimetres: the emulator stops the robot at a wall, which may round

   procedure Start (J : out Judge; P : Plan) is
   begin
      J := (Count => P.Count, Points => P.Points, others => <>);
   end Start;

   procedure See_Position (J : in out Judge; Time : Duration) is
   begin
      J.Last_Seen := Time;
      J.Any_Seen := True;
   end See_Position;

   procedure See_Pose
     (J       : in out Judge;
      Time    : Duration;
      Where   : Robot_Motion.Pose;
      Driving : Boolean)
   is
      function Distance (To : Place) return Long_Float is
        (Sqrt (Long_Float (Where.X - To.X) ** 2
               + Long_Float (Where.Y - To.Y) ** 2) / 1_000.0);

      Room : constant Micro := Micro'Min
        (Micro'Min (Where.X, Robot_Motion.Arena_Width - Where.X),
         Micro'Min (Where.Y, Robot_Motion.Arena_Height - Where.Y))
        - Robot_Motion.Body_Radius;
   begin
      for K in 1 .. J.Count loop
         exit when J.Worst (K - 1) = Long_Float'Last;
         J.Worst (K) := Long_Float'Min
           (J.Worst (K),
            Long_Float'Max (J.Worst (K - 1), Distance (J.Points (K))));
      end loop;
      J.Nearest := Long_Float'Min (J.Nearest, Long_Float (Room) / 1_000.0);
      if Driving and then J.Any_Seen then
         J.Blind := Duration'Max (J.Blind, Time - J.Last_Seen);
      end if;
      J.Driving := Driving;
   end See_Pose;

   procedure Conclude
     (J      : Judge;
      P      : Plan;
      Said   : String;
      Time   : Duration;
      Orders : Natural;
      V      : out Verdict)
   is
      Aborted : constant String := "aborted;";

      procedure Blame (If_So : Boolean; What : String) is
      begin
         if If_So then
            Append
              (V.Wrong, (if Length (V.Wrong) = 0 then "" else ", ") & What);
         end if;
      end Blame;

   begin
      V := (Done      => Said = "done",
            Time      => Time,
            Exact     => Exact_Time (P),
            Pass      => J.Worst (J.Count),
            Clearance => J.Nearest,
            Blind     => J.Blind,
            Orders    => Orders,
            others    => <>);
      for K in 1 .. J.Count loop
         if J.Worst (K) <= Widest_Pass then
            V.Passed := K;
         end if;
      end loop;
      if Index (Said, Aborted) = Said'First then
         V.Reason := To_Unbounded_String
           (Said (Said'First + Aborted'Length .. Said'Last));
      end if;

      Blame (not V.Done and then V.Reason = "", "no end was said");
      Blame
        (V.Done and then V.Passed < J.Count,
         "said done, " & Image (J.Count - V.Passed) & " points not passed");
      Blame (J.Driving, "drives after its end");
      Blame (V.Clearance < Touch, "has touched a wall");
      Blame (V.Blind > Longest_Blind,
             Rounded (Float (V.Blind) * 1_000.0, 0)
             & " ms without a new position");
   end Conclude;

end Mission_Judges;
