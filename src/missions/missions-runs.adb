--  SPDX-License-Identifier: GPL-3.0-or-later

with Missions.Runs.Aims;

package body Missions.Runs with SPARK_Mode is

   --  Microseconds, micrometres, microdegrees

   --  The robot as it is meant to be

   Time_Per_Millimetre : constant := 5_000;   --  200 mm/s
   Time_Per_Degree     : constant := 11_112;  --  90 degrees/s

   --  Limits

   Slowest    : constant := 4;
   --  An order may take its duration times this, and Still_Time

   Still_Time : constant := 2_000_000;
   --  A mission ends when it has made no progress for this time. Progress is
   --  a way or a turn longer than:
   Progress_Way  : constant := 10_000;
   Progress_Turn : constant := 5_000_000;

   Leg_Time                : constant := 15_000_000;
   Leg_Time_Per_Millimetre : constant := Slowest * Time_Per_Millimetre;
   --  A leg may take Leg_Time for its turns and looks, and the time of the
   --  slowest drive

   Ask_Period : constant := 20_000;
   --  Between two questions whether the robot moves

   --  What images show

   Same_Place   : constant := 9_000;
   Same_Heading : constant := 3_000_000;
   --  An image that differs more from the mean shows another place

   Good_Part    : constant := 20_000_000;
   --  A turn seen halfway has turned so far at least, and four times this at
   --  most: its rate is learnt from that

   function After (Time, Span : Microseconds) return Microseconds is
     (if Time <= Microseconds'Last - Span then Time + Span
      else Microseconds'Last);

   function Duration_Of (R : Run) return Microseconds is
     (Microseconds (abs R.Amount)
      * (if R.Movement = Turn then Time_Per_Degree else Time_Per_Millimetre));
   --  Of the order under way, of a robot as it is meant to be

   procedure Finish (R : in out Run; Why : Ending) is
   begin
      R.Ended := True;
      R.Why   := Why;
      R.Stops := (if Why in By_Hand | Session_Over then 0 else Stop_Tries);
   end Finish;

   procedure Finish_Amiss (R : in out Run; What : Movement_Kind) is
   begin
      Finish
        (R,
         (if R.Measured = 0 then No_Progress
          else
            (case What is
                when Halt  => No_Progress,
                when Turn  => Turns_Amiss,
                when Drive => Drives_Amiss)));
   end Finish_Amiss;

   procedure Limit_Leg (R : in out Run; Now : Microseconds) is
      Far : constant Micrometres := Micrometres'Max (0, Distance (R));
   begin
      R.Leg_End := After
        (Now, Leg_Time + Leg_Time_Per_Millimetre * Microseconds (Far / 1_000));
      R.Orders   := Max_Orders;
      R.Anchored := Now;
   end Limit_Leg;

   procedure Check_Limits (R : in out Run; Now : Microseconds)
   with
     Pre  => not R.Ended,
     Post => Is_As_Far (R, R'Old)
       and then (if not R.Ended then Now < R.Leg_End)
   is
   begin
      if Now > After (R.Came, Max_Age) then
         Finish (R, No_Image);
      elsif Now >= R.Leg_End then
         Finish (R, Leg_Too_Long);
      elsif Now > After (R.Anchored, Still_Time) then
         Finish_Amiss (R, R.Amiss);
      elsif R.Phase = Moving
        and then R.Sure
        and then Now > After (R.Given, Slowest * Duration_Of (R) + Still_Time)
      then
         R.Measured := Percent
           (Within
              ((if R.Movement = Turn
                then Wide (abs Difference (R.Mean.Heading, R.Newest.Heading))
                  * Time_Per_Degree / 10_000
                else Wide (Way (R.Mean, R.Newest)) * Time_Per_Millimetre / 10)
               / Wide (Now - R.Given),
               0, Wide (Percent'Last)));
         Finish_Amiss (R, R.Movement);
      end if;
   end Check_Limits;

   procedure End_By (R : in out Run; Why : Abort_Reason) is
   begin
      if not R.Ended then
         Finish (R, Why);
      end if;
   end End_By;

   function Has_Position (R : Run; Now : Microseconds) return Boolean is
     (R.Seen_At <= Now and then Now - R.Seen_At <= Max_Age);
   --  An order may follow from it

   function Next_Look (R : Run; Now : Microseconds) return Microseconds is
     (if R.Ended or else (R.Phase = Aiming and then Has_Position (R, Now))
      then Now
      elsif R.Phase = Moving then
         Microseconds'Max
           (Now, Microseconds'Min (R.Ask_At, After (Now, Max_Age)))
      else After (Now, Ask_Period));

   function Mean_Of (Mean, Newest : Near; Count : Image_Count) return Near is
     (Near_Of (Mean + (Newest - Mean) / Micrometres (Count)))
   with Pre => Count > 0;
   --  Count includes the newest

   procedure Add_Image (R : in out Run)
   with Post => Is_Same (R, R'Old)
   is
      --  The newest one, of the robot at rest
      Where : constant Near_Pose := R.Newest;
      Turn  : constant Bearing   :=
        Difference (R.Mean.Heading, Where.Heading);
      Is_Same : constant Boolean :=
        Way (R.Mean, Where) <= Same_Place and then abs Turn <= Same_Heading;
   begin
      if R.Count = 0 or else not Is_Same then
         R.Confirmed := R.Count = 0 and then R.Expected and then Is_Same;
         R.Count     := 1;
         R.Mean      := Where;
      else
         R.Count  := Natural'Min (R.Count + 1, Max_Images);
         R.Mean.X := Mean_Of (R.Mean.X, Where.X, R.Count);
         R.Mean.Y := Mean_Of (R.Mean.Y, Where.Y, R.Count);
         R.Mean.Heading :=
           Normal (R.Mean.Heading + Turn / Microdegrees (R.Count));
      end if;
   end Add_Image;

   procedure Arrive (R : in out Run; Now : Microseconds)
   with Post => Is_Same (R, R'Old)
   is
      --  The robot does not move any more
      Turned : constant Some_Turn := True_Turn (R.Amount, R.Known.Turns);
   begin
      R.Expected  := False;
      R.Confirmed := False;
      R.Part.Ended := (if Now > R.Given then Now - R.Given else 0);
      if R.Movement = Turn
        and then R.Sure
        and then not R.Upset
        and then R.Known.Distrust = 0
        and then R.Made.Turned ** 2 <= 9 * R.Known.Turn_Weight
      then
         R.Mean.Heading := Normal (R.Mean.Heading + Turned);
         R.Phase        := Aiming;
         Learn_Lag (R.Known, R.Part, Turned);
         return;
      end if;

      R.Phase     := Looking;
      R.Rest_From := After (Now, R.Known.Lag);
      R.Count     := 0;
      R.Learnable :=
        R.Learnable and then R.Sure and then R.Movement /= Halt;
      if R.Movement = Drive
        and then R.Learnable
        and then Knows_Way (R.Known)
      then
         declare
            Length : constant Some_Length :=
              True_Length (R.Amount, R.Known.Drives);
            Half   : constant Microdegrees := Swing (Length, R.Known.Pulled);
            Chord  : constant Bearing      := Normal (R.Mean.Heading + Half);
         begin
            R.Mean :=
              (X       => Near_Of
                 (R.Mean.X
                  + Micrometres (Wide (Length) * Cosine (Chord) / Million)),
               Y       => Near_Of
                 (R.Mean.Y
                  + Micrometres (Wide (Length) * Sine (Chord) / Million)),
               Heading => Normal (Chord + Half));
            R.Expected := True;
         end;
      end if;
   end Arrive;

   procedure See (R : in out Run; What : Sighting) is
   begin
      if R.Some_Image and then What.Number = R.Number then
         return;
      end if;

      R.Some_Image := True;
      R.Number     := What.Number;
      R.Came       := What.Taken;
      if not What.Seen
        or else What.Where.At_Place.X not in Near
        or else What.Where.At_Place.Y not in Near
      then
         R.Missing := Natural'Min (R.Missing + 1, Max_Missing);
         if R.Missing = Max_Missing and then not R.Ended then
            Finish (R, No_Position);
         end if;
         return;
      end if;

      R.Missing := 0;
      R.Seen_At := What.Taken;
      R.Newest  :=
        (What.Where.At_Place.X, What.Where.At_Place.Y, What.Where.Heading);

      if Way (R.Anchor, R.Newest) > Progress_Way
        or else abs Difference (R.Anchor.Heading, R.Newest.Heading)
                > Progress_Turn
      then
         R.Anchor   := R.Newest;
         R.Anchored := What.Taken;
      end if;

      if R.Phase = Looking and then What.Taken >= R.Rest_From then
         Add_Image (R);
      elsif R.Phase = Moving and then R.Movement = Turn then
         if R.Part.Turned = 0 and then What.Taken > R.Given and then R.Sure
         then
            declare
               Part : constant Bearing :=
                 Difference (R.Mean.Heading, R.Newest.Heading);
            begin
               if abs Part in Good_Part .. 4 * Good_Part
                 and then (Part > 0) = (R.Amount > 0)
               then
                  R.Part.Turned := Part;
                  R.Part.Seen   := What.Taken - R.Given;
               end if;
            end;
         end if;
         if Way (R.Mean, R.Newest) > Upset_Way then
            R.Upset := True;
         else
            R.Count  := Natural'Min (R.Count + 1, Max_Images);
            R.Mean.X := Mean_Of (R.Mean.X, R.Newest.X, R.Count);
            R.Mean.Y := Mean_Of (R.Mean.Y, R.Newest.Y, R.Count);
         end if;
      end if;
   end See;

   procedure Start
     (R       : out Run;
      Size    : Arena_Size;
      Targets : Place_Array;
      Count   : Point_Number;
      Now     : Microseconds) is
   begin
      R :=
        (Size    => Size,
         Targets => Targets,
         Legs    => Count,
         Came    => Now,
         Ask_At  => Now,
         others  => <>);
      R.Phase := Looking;
      Limit_Leg (R, Now);
   end Start;

   procedure Step (R : in out Run; Now : Microseconds; Next : out Action) is
   begin
      Next := (others => <>);
      if not R.Ended then
         Check_Limits (R, Now);
      end if;

      if not R.Ended and then R.Awaited = Nothing then
         if R.Phase = Moving then
            if Now >= R.Ask_At then
               Next :=
                 (Ask, (Kind => Commands.Get_Moving, others => <>));
               R.Awaited := Ask;
            end if;
         elsif R.Orders = 0 then
            Finish (R, Leg_Too_Long);
         elsif not R.Halted then
            Aims.Give (R, Halt, 0, Next);
         elsif (R.Phase = Aiming or else R.Count >= Enough_Images
                or else R.Confirmed)
           and then Has_Position (R, Now)
         then
            Aims.Decide (R, Now, Next);
         end if;
      end if;

      if R.Ended then
         if R.Stops > 0 then
            Next := (Stop, (Kind => Commands.Stop, others => <>));
            R.Stops   := R.Stops - 1;
            R.Awaited := Stop;
         else
            Next := (Kind => Leave, others => <>);
         end if;
      end if;
   end Step;

   procedure Tell
     (R : in out Run; Result : Commands.Outcome; Now : Microseconds)
   is
      What : constant Awaited_Kind := R.Awaited;
   begin
      R.Awaited := Nothing;
      case What is
         when Nothing =>
            null;

         when Stop =>
            if Result.Kind /= Commands.Timed_Out then
               R.Stops := 0;
            end if;

         when Ask =>
            if Result.Kind = Commands.Done
              and then Commands.Is_Zero (Result)
            then
               Arrive (R, Now);
            else
               if Result.Kind = Commands.Done and then not R.Sure then
                  R.Sure   := True;
                  R.Ask_At := After (R.Given, Duration_Of (R));
               end if;
               R.Ask_At := Microseconds'Max
                 (R.Ask_At, After (Now, Ask_Period));
            end if;

         when Order =>
            R.Given := Now;
            case Result.Kind is
               when Commands.Done =>
                  R.Refusals := 0;
                  R.Sure     := True;
                  R.Ask_At   := After (Now, Duration_Of (R));
                  if R.Movement = Halt then
                     R.Halted := True;
                     R.Phase  := Looking;
                  end if;

               when Commands.Timed_Out =>
                  --  It may have been taken: whether the robot moves tells
                  R.Sure   := False;
                  R.Ask_At := Now;
                  if R.Movement = Halt then
                     R.Phase := Looking;
                  end if;

               when Commands.Refused =>
                  R.Refusals := Natural'Min (R.Refusals + 1, Refusal_Limit);
                  R.Sure     := False;
                  Arrive (R, Now);
                  if R.Refusals = Refusal_Limit and then not R.Ended then
                     Finish (R, Orders_Refused);
                  end if;

               when Commands.Not_Open | Commands.Not_Opened =>
                  if not R.Ended then
                     Finish (R, Robot_Stopped);
                  end if;
            end case;
      end case;
   end Tell;

end Missions.Runs;
