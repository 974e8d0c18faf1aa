--  SPDX-License-Identifier: GPL-3.0-or-later

package body Missions.Aims with SPARK_Mode is

   Side_Way  : constant := 2_500;
   --  Micrometres. The robot does not turn if it would pass the target by less

   First_Way : constant := 200;
   --  Millimetres of a drive before anything is known: a mission looks at it
   --  in time even if the robot is slow

   procedure Choose
     (Here, Goal : Near_Pose;
      K          : Knowledge;
      Turned     : Degrees;
      Turns_Made : Turn_Count;
      Size       : Arena_Size;
      Movement   : out Movement_Kind;
      Amount     : out Drive_Length)
   is
      Towards : constant Bearing     :=
        Direction (Goal.X - Here.X, Goal.Y - Here.Y);
      Ahead   : constant Micrometres :=
        Micrometres'Max (0, Way (Here, Goal));
      Is_Back : constant Boolean     :=
        abs Difference (Here.Heading, Towards) > Half_Turn / 2;
      --  backward, where that means less turning
      Front   : constant Bearing     :=
        (if Is_Back then Normal (Towards + Half_Turn) else Towards);

      subtype Forward_Length is Drive_Length range 0 .. Drive_Length'Last;

      function Signed (Length : Forward_Length) return Drive_Length is
        (if Is_Back then -Length else Length);

      function Course (Length : Forward_Length) return Bearing is
        (Normal
           (Front
            - Swing (True_Length (Signed (Length), K.Drives), K.Pulled)));

      function Is_Good
        (Length : Forward_Length; Heading : Bearing) return Boolean
      is (Is_Permitted
            (((Here.X, Here.Y), Heading), Signed (Length),
             Doubts_Of (K, Turned), Size));

      procedure Shorten (Length : in out Forward_Length)
      with Pre => Length > 0, Post => Length < Length'Old
      is
      begin
         Length := Length - Integer'Max (1, Length / 16);
      end Shorten;

      Wanted  : constant Wide :=
        (Wide (Ahead) * 10 + Wide (K.Drives) / 2) / Wide (K.Drives);
      Length  : Forward_Length :=
        Forward_Length
          (Within
             (Wanted, 1,
              (if not Knows_Way (K) then First_Way
               else Wide (Forward_Length'Last))));
      Angle   : Bearing;
      Half    : Wide;
      Ordered : Degrees;
   begin
      Movement := Halt;
      Amount := 0;
      while Length > 0 and then not Is_Good (Length, Course (Length)) loop
         pragma Loop_Variant (Decreases => Length);
         Shorten (Length);
      end loop;
      if Length = 0 then
         return;
      end if;

      Angle   := Difference (Here.Heading, Course (Length));
      Half    := Wide (K.Turns) / 2;
      Ordered := Degrees
        (Within
           ((Wide (Angle) / 100 + (if Angle < 0 then -Half else Half))
            / Wide (K.Turns),
            Wide (Degrees'First), Wide (Degrees'Last)));
      if Ordered /= 0
        and then
          (abs Angle > Half_Turn / 4
           or else abs (Wide (Ahead) * Sine (Angle) / Million) > Side_Way)
        and then abs Angle >
          (if Turns_Made = 2 then 4_000_000
           elsif not Knows_Way (K) then 3_000_000
           elsif Turns_Made = 1 then 1_000_000
           else 0)
      then
         Movement := Turn;
         Amount := Ordered;
         return;
      end if;

      while Length > 0 and then not Is_Good (Length, Here.Heading) loop
         pragma Loop_Variant (Decreases => Length);
         Shorten (Length);
      end loop;
      if Length > 0 then
         Movement := Drive;
         Amount := Signed (Length);
      elsif Ordered /= 0 then
         Movement := Turn;
         Amount := Ordered;
      end if;
   end Choose;

end Missions.Aims;
