--  SPDX-License-Identifier: GPL-3.0-or-later

with Missions.Angles; use Missions.Angles;

package body Missions.Runs with SPARK_Mode is

   --  Limits: microseconds, micrometres, microdegrees

   Still_Time    : constant := 2_000_000;
   --  without progress, which is at least:
   Progress_Way  : constant := 10_000;
   Progress_Turn : constant := 5_000_000;

   Leg_Time                 : constant := 15_000_000;
   Leg_Time_Per_Millimetre  : constant := 20_000;

   --  The robot as it is meant to be

   Time_Per_Millimetre : constant := 5_000;   --  200 mm/s
   Time_Per_Degree     : constant := 11_112;  --  90 degrees/s

   Slowest    : constant := 4;
   --  times its duration an order may take, and Still_Time

   Ask_Period : constant := 20_000;

   --  Looks

   Same_Place   : constant := 9_000;
   Same_Heading : constant := 3_000_000;
   Upset_Way    : constant := 15_000;
   --  Distance from the mean place: more in a turn means that the robot was
   --  moved

   Enough_Images : constant := 2;
   Many_Images   : constant := 4;

   Unsure_Way : constant := 3_000;
   --  If the distance to the target differs from the limit by less, more
   --  images are waited for

   --  Orders

   Good_Part    : constant := 20_000_000;
   --  A turn seen halfway has turned so far at least, and four times this at
   --  most: its rate is learnt from that

   --  Functions

   function After (Time, Span : Microseconds) return Microseconds is
     (if Time <= Microseconds'Last - Span then Time + Span
      else Microseconds'Last);

   function Mean_Of (Mean, Newest : Near; Count : Image_Count) return Near is
     (Near_Of (Mean + (Newest - Mean) / Micrometres (Count)))
   with Pre => Count > 0;
   --  Count includes the newest

   function Target (R : Run) return Near_Pose is
     ((X       => Near_Of (R.Targets (R.Leg).X),
       Y       => Near_Of (R.Targets (R.Leg).Y),
       Heading => 0));

   function Duration_Of (R : Run) return Microseconds is
     (Microseconds (abs R.Amount)
      * (if R.Movement = Turn then Time_Per_Degree else Time_Per_Millimetre));
   --  Of the order under way, of a robot as it is meant to be

   function There (Images : Image_Count) return Micrometres is
     (case Images is
         when 0 .. 1          => 6_000,
         when 2               => 8_000,
         when 3 .. Max_Images => 9_000);
   --  So near to the target, it is reached: the more images, the better it is
   --  known

   --  Used in the contracts

   function Is_Same (R, Before : Run) return Boolean is
     (R.Ended = Before.Ended
      and then R.Why = Before.Why
      and then R.Leg = Before.Leg
      and then R.Orders = Before.Orders
      and then R.Leg_End = Before.Leg_End
      and then R.Seen_At = Before.Seen_At
      and then R.Size = Before.Size)
   with Ghost;
   --  Neither further nor ended

   function Is_Good_Order (R, Before : Run; Next : Action) return Boolean is
     (Next.Kind = Order
      and then Next.Request.Kind = Robot.Session.Drive
      and then Is_Permitted (R, Next.Request)
      and then not R.Ended
      and then Orders_Left (R) < Orders_Left (Before)
      and then R.Leg_End = Before.Leg_End
      and then R.Seen_At = Before.Seen_At)
   with Ghost;

   --  Operations

   procedure Finish (R : in out Run; Why : Ending)
   with
     Pre  => not R.Ended,
     Post => R.Ended
       and then R.Why = Why
       and then R.Leg = R.Leg'Old
       and then R.Orders = R.Orders'Old
       and then R.Seen_At = R.Seen_At'Old
   is
   begin
      R.Ended := True;
      R.Why   := Why;
      R.Stops := (if Why in By_Hand | Session_Over then 0 else Stop_Tries);
   end Finish;

   procedure Finish_Amiss (R : in out Run; What : Movement_Kind)
   with
     Pre  => not R.Ended,
     Post => R.Ended
       and then R.Leg = R.Leg'Old
       and then R.Orders = R.Orders'Old
       and then R.Seen_At = R.Seen_At'Old
   is
      --  It goes so far amiss, as measured; Halt, or none measured: it does
      --  not go on
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

   procedure Give
     (R        : in out Run;
      Movement : Movement_Kind;
      Amount   : Drive_Length;
      Next     : out Action)
   with
     Pre  => not R.Ended
       and then R.Orders > 0
       and then
         (if Movement = Drive then
             Missions.Guards.Is_Permitted
               (Position (R), Amount, Doubts (R), R.Size)),
     Post => Next.Kind = Order
       and then Next.Request.Kind =
         (if Movement = Halt then Robot.Session.Stop
          else Robot.Session.Drive)
       and then Is_Permitted (R, Next.Request)
       and then not R.Ended
       and then Orders_Left (R) < Orders_Left (R'Old)
       and then R.Leg_End = R.Leg_End'Old
       and then R.Seen_At = R.Seen_At'Old
   is
   begin
      case Movement is
         when Halt  =>
            Next := (Order, (Kind => Robot.Session.Stop, others => <>));

         when Turn  =>
            Next :=
              (Order, (Robot.Session.Drive, (Robot.Protocol.Turn, Amount)));

         when Drive =>
            Next :=
              (Order, (Robot.Session.Drive, (Robot.Protocol.Move, Amount)));
      end case;
      R.Awaited  := Order;
      R.Movement := Movement;
      R.Amount   := Amount;
      R.Phase    := Moving;
      R.Upset    := False;
      R.Orders   := R.Orders - 1;
      case Movement is
         when Halt =>
            null;

         when Turn =>
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
            R.Turns_Made := 0;
            R.Made.From.X := R.Mean.X;
            R.Made.From.Y := R.Mean.Y;
            if R.Made.Turned = 0 then
               R.Made.From.Heading := R.Mean.Heading;
            end if;
            R.Made.Driven := Amount;
      end case;
   end Give;

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

   procedure Aim (R : in out Run; Goal : Near_Pose; Next : out Action)
   with
     Pre  => not R.Ended and then R.Orders > 0,
     Post =>
       (if Next.Kind = Nothing then Is_Same (R, R'Old)
        else Is_Good_Order (R, R'Old, Next))
   is
      --  A turn or a drive towards the goal; Nothing: none is permitted
      Movement : Movement_Kind;
      Amount   : Drive_Length;
   begin
      Missions.Aims.Choose
        (R.Mean, Goal, R.Known, R.Made.Turned, R.Turns_Made, R.Size,
         Movement, Amount);
      if Movement = Halt then
         Next := (others => <>);
      else
         Give (R, Movement, Amount, Next);
      end if;
   end Aim;

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

   procedure Limit_Leg (R : in out Run; Now : Microseconds)
   with
     Post => R.Orders = Max_Orders
       and then R.Ended = R.Ended'Old
       and then R.Leg = R.Leg'Old
       and then R.Legs = R.Legs'Old
       and then R.Size = R.Size'Old
       and then R.Seen_At = R.Seen_At'Old
   is
      --  It begins now
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
     Post => R.Leg = R.Leg'Old
       and then R.Orders = R.Orders'Old
       and then R.Seen_At = R.Seen_At'Old
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

   procedure Compare (R : in out Run)
   with
     Pre  => not R.Ended,
     Post => R.Leg = R.Leg'Old
       and then R.Orders = R.Orders'Old
       and then R.Seen_At = R.Seen_At'Old
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

   procedure Decide
     (R : in out Run; Now : Microseconds; Next : out Action)
   with
     Pre  => not R.Ended
       and then Now < R.Leg_End
       and then R.Orders > 0
       and then R.Seen_At <= Now
       and then Now - R.Seen_At <= Max_Age,
     Post => Is_Kept (R, R'Old)
       and then R.Seen_At = R.Seen_At'Old
       and then
         (case Next.Kind is
             when Nothing => True,
             when Order   => not R.Ended
               and then Next.Request.Kind = Robot.Session.Drive
               and then Is_Permitted (R, Next.Request)
               and then Orders_Left (R) < Orders_Left (R'Old)
               and then Now < R.Leg_End,
             when others  => False)
   is
      --  The robot rests where it is believed to be
      Left : Micrometres := Way (R.Mean, Target (R));
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

      Aim (R, Target (R), Next);
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

   function Distance (R : Run) return Micrometres is
     (Way (R.Newest, Target (R)));

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
      R.Seen    := True;
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
                 (Ask, (Kind => Robot.Session.Get_Moving, others => <>));
               R.Awaited := Ask;
            end if;
         elsif R.Orders = 0 then
            Finish (R, Leg_Too_Long);
         elsif not R.Halted then
            Give (R, Halt, 0, Next);
         elsif (R.Phase = Aiming or else R.Count >= Enough_Images
                or else R.Confirmed)
           and then Has_Position (R, Now)
         then
            Decide (R, Now, Next);
         end if;
      end if;

      if R.Ended then
         if R.Stops > 0 then
            Next := (Stop, (Kind => Robot.Session.Stop, others => <>));
            R.Stops   := R.Stops - 1;
            R.Awaited := Stop;
         else
            Next := (Kind => Leave, others => <>);
         end if;
      end if;
   end Step;

   procedure Tell
     (R : in out Run; Result : Robot.Session.Outcome; Now : Microseconds)
   is
      What : constant Awaited_Kind := R.Awaited;
   begin
      R.Awaited := Nothing;
      case What is
         when Nothing =>
            null;

         when Stop =>
            if Result.Kind /= Robot.Session.Timed_Out then
               R.Stops := 0;
            end if;

         when Ask =>
            if Result.Kind = Robot.Session.Done
              and then Robot.Session.Is_Zero (Result)
            then
               Arrive (R, Now);
            else
               if Result.Kind = Robot.Session.Done and then not R.Sure then
                  R.Sure   := True;
                  R.Ask_At := After (R.Given, Duration_Of (R));
               end if;
               R.Ask_At := Microseconds'Max
                 (R.Ask_At, After (Now, Ask_Period));
            end if;

         when Order =>
            R.Given := Now;
            case Result.Kind is
               when Robot.Session.Done =>
                  R.Refusals := 0;
                  R.Sure     := True;
                  R.Ask_At   := After (Now, Duration_Of (R));
                  if R.Movement = Halt then
                     R.Halted := True;
                     R.Phase  := Looking;
                  end if;

               when Robot.Session.Timed_Out =>
                  --  It may have been taken: whether the robot moves tells
                  R.Sure   := False;
                  R.Ask_At := Now;
                  if R.Movement = Halt then
                     R.Phase := Looking;
                  end if;

               when Robot.Session.Refused =>
                  R.Refusals := Natural'Min (R.Refusals + 1, Refusal_Limit);
                  R.Sure     := False;
                  Arrive (R, Now);
                  if R.Refusals = Refusal_Limit and then not R.Ended then
                     Finish (R, Orders_Refused);
                  end if;

               when Robot.Session.Not_Open | Robot.Session.Not_Opened =>
                  if not R.Ended then
                     Finish (R, Robot_Stopped);
                  end if;
            end case;
      end case;
   end Tell;

end Missions.Runs;
