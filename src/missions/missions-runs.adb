--  SPDX-License-Identifier: GPL-3.0-or-later

package body Missions.Runs with SPARK_Mode is

   function Target (R : Run) return Near_Pose is
     ((X       => Near_Of (R.Targets (R.Leg).X),
       Y       => Near_Of (R.Targets (R.Leg).Y),
       Heading => 0));

   function Distance (R : Run) return Micrometres is
     (Way (R.Newest, Target (R)));

   function After (Time, Span : Microseconds) return Microseconds is
     (if Time <= Microseconds'Last - Span then Time + Span
      else Microseconds'Last);

   function Duration_Of (R : Run) return Microseconds is
     (Microseconds (abs R.Amount)
      * (if R.Movement = Turn then Time_Per_Degree else Time_Per_Millimetre));
   --  Of the order under way, of a robot as it is meant to be

   procedure Finish (R : in out Run; Why : Ending) is
      --  No effect once it has ended
   begin
      if not R.Ended then
         R.Ended := True;
         R.Why   := Why;
         R.Stops :=
           (if Why in By_Hand | Session_Over then 0 else Stop_Tries);
      end if;
   end Finish;

   procedure Finish_Amiss (R : in out Run; What : Movement_Kind) is
      --  Movements of that kind have another length than ordered. Halt, or
      --  none measured: the robot makes no progress
   begin
      Finish
        (R,
         (if R.Measured = 0 or else What = Halt then No_Progress
          elsif What = Turn then Turns_Amiss
          else Drives_Amiss));
   end Finish_Amiss;

   procedure Limit_Leg (R : in out Run; Now : Microseconds) is
      --  The leg begins now
      Far : constant Micrometres := Micrometres'Max (0, Distance (R));
   begin
      R.Leg_End := After
        (Now, Leg_Time + Leg_Time_Per_Millimetre * Microseconds (Far / 1_000));
      R.Orders   := Max_Orders;
      R.Anchored := Now;
   end Limit_Leg;

   procedure Check_Limits (R : in out Run; Now : Microseconds) is
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
                then Wide
                  (abs Difference (R.Rest.Mean.Heading, R.Newest.Heading))
                  * Time_Per_Degree / 10_000
                else Wide (Way (R.Rest.Mean, R.Newest))
                  * Time_Per_Millimetre / 10)
               / Wide (Now - R.Given),
               0, Wide (Percent'Last)));
         Finish_Amiss (R, R.Movement);
      end if;
   end Check_Limits;

   procedure End_By (R : in out Run; Why : Abort_Reason) is
   begin
      Finish (R, Why);
   end End_By;

   function Next_Look (R : Run; Now : Microseconds) return Microseconds is
     (if R.Ended or else (R.Phase = Aiming and then Has_Position (R, Now))
      then Now
      elsif R.Phase = Moving then
         Microseconds'Max
           (Now, Microseconds'Min (R.Ask_At, After (Now, Max_Age)))
      else After (Now, Ask_Period));

   procedure Arrive (R : in out Run; Now : Microseconds) is
      --  The robot does not move any more
      Turned : constant Some_Turn := True_Turn (R.Amount, R.Known.Turns);
   begin
      R.Rest.Expected  := False;
      R.Rest.Confirmed := False;
      R.Part.Ended := (if Now > R.Given then Now - R.Given else 0);
      if R.Movement = Turn
        and then R.Sure
        and then not R.Upset
        and then R.Known.Distrust = 0
        and then R.Made.Turned ** 2 <= 9 * R.Known.Turn_Weight
      then
         R.Rest.Mean.Heading := Normal (R.Rest.Mean.Heading + Turned);
         R.Phase := Aiming;
         Learn_Lag (R.Known, R.Part, Turned);
      else
         R.Phase      := Looking;
         R.Rest_From  := After (Now, R.Known.Lag);
         R.Rest.Count := 0;
         R.Learnable  :=
           R.Learnable and then R.Sure and then R.Movement /= Halt;
         if R.Movement = Drive
           and then R.Learnable
           and then Knows_Way (R.Known)
         then
            R.Rest.Mean := After_Drive (R.Known, R.Rest.Mean, R.Amount);
            R.Rest.Expected := True;
         end if;
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
         if R.Missing = Max_Missing then
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
         Add_Image (R.Rest, R.Newest);
      elsif R.Phase = Moving and then R.Movement = Turn then
         if R.Part.Turned = 0 and then What.Taken > R.Given and then R.Sure
         then
            declare
               Part : constant Bearing :=
                 Difference (R.Rest.Mean.Heading, R.Newest.Heading);
            begin
               if abs Part in Good_Part .. 4 * Good_Part
                 and then (Part > 0) = (R.Amount > 0)
               then
                  R.Part.Turned := Part;
                  R.Part.Seen   := What.Taken - R.Given;
               end if;
            end;
         end if;
         if Way (R.Rest.Mean, R.Newest) > Upset_Way then
            R.Upset := True;
         else
            Add_Place (R.Rest, R.Newest);
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
      Limit_Leg (R, Now);
   end Start;

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
            Next := (Order, (Commands.Drive, (Commands.Turn, Amount)));
            R.Turns_Made  := Natural'Min (2, R.Turns_Made + 1);
            R.Part.Turned := 0;
            if R.Made.Turned = 0 then
               R.Made.From := R.Rest.Mean;
            end if;
            if abs (R.Made.Turned + Amount) <= Degrees'Last then
               R.Made.Turned := R.Made.Turned + Amount;
            else
               R.Learnable := False;
            end if;

         when Drive =>
            Next := (Order, (Commands.Drive, (Commands.Move, Amount)));
            R.Turns_Made := 0;
            R.Made.From.X := R.Rest.Mean.X;
            R.Made.From.Y := R.Rest.Mean.Y;
            if R.Made.Turned = 0 then
               R.Made.From.Heading := R.Rest.Mean.Heading;
            end if;
            R.Made.Driven := Amount;
      end case;
   end Give;

   procedure Decide (R : in out Run; Now : Microseconds; Next : out Action)
   with
     Pre  => not R.Ended
       and then Now < R.Leg_End
       and then R.Orders > 0
       and then Has_Position (R, Now),
     Post => Is_Kept (R, R'Old)
       and then R.Seen_At = R.Seen_At'Old
       and then Next.Kind in Nothing | Order
       and then
         (if Next.Kind = Order then
             Is_Permitted (R, Next.Request, Now)
             and then not R.Ended
             and then Orders_Left (R) < Orders_Left (R'Old))
   is
      --  For a robot at rest: gives an order, waits for more images, or ends
      --  the mission
      Centre   : constant Near_Pose :=
        (X       => Near (R.Size.Width) * 5_000,
         Y       => Near (R.Size.Height) * 5_000,
         Heading => 0);
      Left     : Micrometres := Way (R.Rest.Mean, Target (R));
      Amiss    : Movement_Kind;
      Part     : Percent;
      Is_Above : Boolean;
      Movement : Movement_Kind;
      Amount   : Drive_Length;
   begin
      Next := (others => <>);
      if R.Phase = Looking then
         if Left > There (R.Rest.Count)
           and then
             (R.Rest.Count < Enough_Images
              or else
                (R.Rest.Count < Many_Images
                 and then Left <= There (R.Rest.Count) + Unsure_Way))
         then
            return;
         end if;

         if R.Learnable then
            --  If no Gain explains what is seen, the mission ends: at once if
            --  the robot moved further than ordered, else the second time
            Compare (R.Known, R.Made, R.Rest.Mean, Amiss, Part, Is_Above);
            if Amiss = Halt then
               if R.Made.Driven = 0
                 and then R.Made.Turned /= 0
                 and then R.Turns_Made = 1
               then
                  Learn_Lag
                    (R.Known, R.Part,
                     Turn_Seen (R.Known, R.Made, R.Rest.Mean));
               end if;
               Learn (R.Known, R.Made, R.Rest.Mean);
            else
               R.Measured := Part;
               if (R.Amiss = Amiss and then Part > 0) or else Is_Above then
                  Finish_Amiss (R, Amiss);
                  return;
               end if;
               R.Known.Distrust := Distrusted;
            end if;
            R.Amiss := Amiss;
         end if;
         R.Made := (From => R.Made.From, others => 0);
         R.Learnable := True;
         R.Phase     := Aiming;
         while Left <= There (R.Rest.Count) loop
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
            Left := Way (R.Rest.Mean, Target (R));
         end loop;
         if Now >= R.Leg_End then
            Finish (R, Leg_Too_Long);
            return;
         end if;
      end if;

      Choose
        (R.Rest.Mean, Target (R), R.Known, R.Made.Turned, R.Turns_Made, R.Size,
         Movement, Amount);
      if Movement = Halt then
         Choose
           (R.Rest.Mean, Centre, R.Known, R.Made.Turned, R.Turns_Made, R.Size,
            Movement, Amount);
      end if;
      if Movement = Halt then
         Finish (R, No_Way);
      else
         Give (R, Movement, Amount, Next);
      end if;
   end Decide;

   procedure Step (R : in out Run; Now : Microseconds; Next : out Action) is
   begin
      Next := (others => <>);
      if not R.Ended then
         Check_Limits (R, Now);
      end if;

      if not R.Ended and then R.Awaited = Nothing then
         if R.Phase = Moving then
            if Now >= R.Ask_At then
               Next := (Ask, (Kind => Commands.Get_Moving, others => <>));
               R.Awaited := Ask;
            end if;
         elsif R.Orders = 0 then
            Finish (R, Leg_Too_Long);
         elsif not R.Halted then
            Give (R, Halt, 0, Next);
         elsif (R.Phase = Aiming or else R.Rest.Count >= Enough_Images
                or else R.Rest.Confirmed)
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
                  --  The robot may have taken it: it is asked whether it moves
                  R.Sure   := False;
                  R.Ask_At := Now;
                  if R.Movement = Halt then
                     R.Phase := Looking;
                  end if;

               when Commands.Refused =>
                  R.Refusals := Natural'Min (R.Refusals + 1, Refusal_Limit);
                  R.Sure     := False;
                  Arrive (R, Now);
                  if R.Refusals = Refusal_Limit then
                     Finish (R, Orders_Refused);
                  end if;

               when Commands.Not_Open | Commands.Not_Opened =>
                  Finish (R, Robot_Stopped);
            end case;
      end case;
   end Tell;

end Missions.Runs;
