--  SPDX-License-Identifier: GPL-3.0-or-later

package body Missions.Runs.Aims with SPARK_Mode is

   Side_Way  : constant := 2_500;
   --  Micrometres. The robot does not turn if it would pass the target by less

   First_Way : constant := 200;
   --  Millimetres of a drive before anything is known: a mission looks at it
   --  in time even if the robot is slow

   Many_Images : constant := 4;

   Unsure_Way : constant := 3_000;
   --  If the distance to the target differs from the limit by less, more
   --  images are waited for

   function There (Images : Image_Count) return Micrometres is
     (case Images is
         when 0 .. 1          => 6_000,
         when 2               => 8_000,
         when 3 .. Max_Images => 9_000);
   --  So near to the target, it is reached: the more images, the better it is
   --  known

   procedure Give
     (R        : in out Run;
      Movement : Movement_Kind;
      Amount   : Drive_Length;
      Next     : out Action) is
   begin
      R.Awaited  := Order;
      R.Movement := Movement;
      R.Amount   := Amount;
      R.Phase    := Moving;
      R.Upset    := False;
      R.Orders   := R.Orders - 1;
      case Movement is
         when Halt =>
            Next := (Order, (Kind => Commands.Stop, others => <>));

         when Turn =>
            Next :=
              (Order, (Commands.Drive, (Commands.Turn, Amount)));
            R.Turns_Made  := Natural'Min (2, R.Turns_Made + 1);
            R.Part.Turned := 0;
            if R.Made.Turned = 0 then
               R.Made.From := R.Mean;
            end if;
            if abs (R.Made.Turned + Amount) <= Degrees'Last then
               R.Made.Turned := R.Made.Turned + Amount;
            else
               R.Learnable := False;
            end if;

         when Drive =>
            Next :=
              (Order, (Commands.Drive, (Commands.Move, Amount)));
            R.Turns_Made := 0;
            R.Made.From.X := R.Mean.X;
            R.Made.From.Y := R.Mean.Y;
            if R.Made.Turned = 0 then
               R.Made.From.Heading := R.Mean.Heading;
            end if;
            R.Made.Driven := Amount;
      end case;
   end Give;

   procedure Choose
     (Here, Goal : Near_Pose;
      K          : Knowledge;
      Turned     : Degrees;
      Turns_Made : Turn_Count;
      Size       : Arena_Size;
      Movement   : out Movement_Kind;
      Amount     : out Drive_Length)
   with
     Post =>
       (if Movement = Drive then
           Missions.Guards.Is_Permitted
             (Pose_Of (Here), Amount, Doubts_Of (K, Turned), Size))
   is
      --  A turn or a drive towards Goal, of a robot that rests Here and has
      --  Turned since it was looked at; Halt: none is permitted
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

   procedure Aim (R : in out Run; Goal : Near_Pose; Next : out Action)
   with
     Pre  => not R.Ended and then R.Orders > 0,
     Post =>
       (if Next.Kind = Nothing then Is_Same (R, R'Old)
        else Is_Good_Order (R, R'Old, Next)
          and then R.Leg_End = R.Leg_End'Old)
   is
      --  The same; Nothing: none is permitted
      Movement : Movement_Kind;
      Amount   : Drive_Length;
   begin
      Choose
        (R.Mean, Goal, R.Known, R.Made.Turned, R.Turns_Made, R.Size,
         Movement, Amount);
      if Movement = Halt then
         Next := (others => <>);
      else
         Give (R, Movement, Amount, Next);
      end if;
   end Aim;

   procedure Compare (R : in out Run)
   with
     Pre  => not R.Ended,
     Post => Is_As_Far (R, R'Old)
   is
      --  What was ordered since the last look with what is seen now: it ends
      --  the mission if no Gain explains them twice in a row, or at once if it
      --  was too much
      Drives : constant Boolean := R.Made.Driven /= 0;
      Seen   : constant Wide :=
        (if Drives then Wide (Way (R.Made.From, R.Mean))
         else Wide (Turn_Seen (R.Known, R.Made, R.Mean))
           * (if R.Made.Turned < 0 then -1 else 1));
      Asked  : constant Wide :=
        (if Drives then abs Wide (R.Made.Driven) * 1_000
         else abs Wide (R.Made.Turned) * Million);
      Slack  : constant Wide := (if Drives then Upset_Way else Surprise);
      Still  : constant Wide := (if Drives then 1_000 else Million);
      --  Less is none: that is seen of a robot at rest
      What   : constant Movement_Kind := (if Drives then Drive else Turn);
   begin
      if Seen + Slack >= Asked * Wide (Gain'First) / 10_000
        and then Seen - Slack <= Asked * Wide (Gain'Last) / 10_000
      then
         R.Amiss := Halt;
         return;
      end if;
      R.Measured := Percent
        (Within
           ((if Seen < Still then 0 else Seen * 100 / Wide'Max (1, Asked)),
            0, Wide (Percent'Last)));
      if (R.Amiss = What and then R.Measured > 0) or else Seen > Asked then
         Finish_Amiss (R, What);
      else
         R.Amiss    := What;
         R.Known.Distrust := Distrusted;
      end if;
   end Compare;

   procedure Decide (R : in out Run; Now : Microseconds; Next : out Action)
   is
      Before : constant Run := R with Ghost;
      Left   : Micrometres := Way (R.Mean, Target (R));
   begin
      Next := (others => <>);
      if R.Phase = Looking then
         if Left > There (R.Count)
           and then
             (R.Count < Enough_Images
              or else
                (R.Count < Many_Images
                 and then Left <= There (R.Count) + Unsure_Way))
         then
            return;
         end if;

         if R.Learnable then
            Compare (R);
            if R.Ended then
               return;
            elsif R.Amiss = Halt then
               if R.Made.Driven = 0
                 and then R.Made.Turned /= 0
                 and then R.Turns_Made = 1
               then
                  Learn_Lag
                    (R.Known, R.Part, Turn_Seen (R.Known, R.Made, R.Mean));
               end if;
               Learn (R.Known, R.Made, R.Mean);
            end if;
         end if;
         pragma Assert (Is_Kept (R, Before));
         R.Made.Turned    := 0;
         R.Made.Driven    := 0;
         R.Learnable := True;
         R.Phase     := Aiming;
         while Left <= There (R.Count) loop
            pragma Loop_Invariant
              (Is_Kept (R, R'Loop_Entry)
               and then not R.Ended
               and then R.Orders > 0
               and then R.Seen_At = R.Seen_At'Loop_Entry);
            pragma Loop_Variant (Increases => R.Leg);
            if R.Leg >= R.Legs then
               Finish (R, Completed);
               return;
            end if;
            R.Leg := R.Leg + 1;
            Limit_Leg (R, Now);
            Left := Way (R.Mean, Target (R));
         end loop;
         if Now >= R.Leg_End then
            Finish (R, Leg_Too_Long);
            return;
         end if;
      end if;

      pragma Assert (Is_Kept (R, Before));
      Aim (R, Target (R), Next);
      pragma Assert (Orders_Left (R) <= Orders_Left (Before));
      if Next.Kind = Nothing then
         Aim (R,
              (X       => Near (R.Size.Width) * 5_000,
               Y       => Near (R.Size.Height) * 5_000,
               Heading => 0),
              Next);
      end if;
      if Next.Kind = Nothing then
         Finish (R, No_Way);
      end if;
   end Decide;

end Missions.Runs.Aims;
