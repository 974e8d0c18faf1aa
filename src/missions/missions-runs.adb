--  SPDX-License-Identifier: GPL-3.0-or-later

with Missions.Runs.Looks;

package body Missions.Runs with SPARK_Mode is

   --  Limits: microseconds, micrometres, microdegrees

   Still_Time : constant := 2_000_000;
   --  without progress (Missions.Runs.Looks)

   Leg_Time                 : constant := 15_000_000;
   Leg_Time_Per_Millimetre  : constant := 20_000;

   --  The robot as it is meant to be

   Time_Per_Millimetre : constant := 5_000;   --  200 mm/s
   Time_Per_Degree     : constant := 11_112;  --  90 degrees/s

   Slowest    : constant := 4;
   --  times its duration an order may take, and Still_Time

   Ask_Period : constant := 20_000;

   --  Looks

   Enough_Images : constant := 2;
   Many_Images   : constant := 4;

   Unsure_Way : constant := 3_000;
   --  If the distance to the target differs from the limit by less, more
   --  images are waited for

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

   function Is_Good_Order (R, Before : Run; Next : Action) return Boolean is
     (Next.Kind = Order
      and then Next.Request.Kind = Commands.Drive
      and then Is_Permitted (R, Next.Request)
      and then not R.Ended
      and then Orders_Left (R) < Orders_Left (Before)
      and then R.Leg_End = Before.Leg_End
      and then R.Seen_At = Before.Seen_At)
   with Ghost;

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
         (if Movement = Halt then Commands.Stop
          else Commands.Drive)
       and then Is_Permitted (R, Next.Request)
       and then not R.Ended
       and then Orders_Left (R) < Orders_Left (R'Old)
       and then R.Leg_End = R.Leg_End'Old
       and then R.Seen_At = R.Seen_At'Old
   is
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
               and then Next.Request.Kind = Commands.Drive
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
            Looks.Compare (R);
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
      Looks.See (R, What);
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
               Looks.Arrive (R, Now);
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
                  Looks.Arrive (R, Now);
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
