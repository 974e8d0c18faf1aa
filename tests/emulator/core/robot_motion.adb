--  SPDX-License-Identifier: GPL-3.0-or-later
--  Where the emulated robot stands: positions along one straight segment
--  at a time, so that rounding does not add up.

package body Robot_Motion with SPARK_Mode is

   Million : constant := 1_000_000;

   subtype Fraction is Micro range 0 .. Million;
   subtype Component is Micro range -Million .. Million;
   subtype Quarter is Micro range 0 .. Full_Turn / 4;

   Stride : constant := 1_024;
   --  Micrometres of an arc, halved 10 times to find where it meets a wall

   Strides : constant := 1_100;
   --  More than the longest arc that fits between the walls: 83 cm from
   --  corner to corner

   Longest_Way : constant := (Strides + 1) * Stride;

   subtype Way is Micro range -Longest_Way .. Longest_Way;
   --  Micrometres, negative backward

   Sines : constant array (Micro range 0 .. 90) of Fraction :=
   --  Of whole degrees, in millionths
     (0, 17_452, 34_899, 52_336, 69_756, 87_156, 104_528, 121_869, 139_173,
      156_434, 173_648, 190_809, 207_912, 224_951, 241_922, 258_819,
      275_637, 292_372, 309_017, 325_568, 342_020, 358_368, 374_607,
      390_731, 406_737, 422_618, 438_371, 453_990, 469_472, 484_810,
      500_000, 515_038, 529_919, 544_639, 559_193, 573_576, 587_785,
      601_815, 615_661, 629_320, 642_788, 656_059, 669_131, 681_998,
      694_658, 707_107, 719_340, 731_354, 743_145, 754_710, 766_044,
      777_146, 788_011, 798_636, 809_017, 819_152, 829_038, 838_671,
      848_048, 857_167, 866_025, 874_620, 882_948, 891_007, 898_794,
      906_308, 913_545, 920_505, 927_184, 933_580, 939_693, 945_519,
      951_057, 956_305, 961_262, 965_926, 970_296, 974_370, 978_148,
      981_627, 984_808, 987_688, 990_268, 992_546, 994_522, 996_195,
      997_564, 998_630, 999_391, 999_848, 1_000_000);

   type Place_In_Plane is record
      X, Y : Micro range -2 ** 32 .. 2 ** 32;
   end record;

   function Room
     (Position, Low, High : Micro; Along : Component) return Micro
   with
     Pre  => Low in 0 .. Million
             and then High in Low .. Million
             and then Position in Low .. High,
     Post => Room'Result >= 0
   is
      --  How far one can travel from Position before the coordinate, which
      --  changes by Along millionths of the travel, leaves Low .. High
   begin
      if Along > 0 then
         return (High - Position) * Million / Along;
      elsif Along < 0 then
         return (Position - Low) * Million / (-Along);
      else
         return Micro'Last;
      end if;
   end Room;

   function Place_After
     (From : Pose; Pull : Pull_Angle; Length : Way) return Place_In_Plane
   is
      --  At the end of an arc of that length, as if there were no walls
      --  The chord of the arc: it leads half of the turn to the side, and
      --  with h, that half in radians, it is shorter by sin h / h

      Half    : constant Micro range -20 * Million .. 20 * Million :=
        Micro (Pull) * Length / 2;
      --  Microdegrees: degrees per metre are microdegrees per micrometre
      Radians : constant Micro range -Million / 2 .. Million / 2 :=
        Half * 17_453 / Million;
      --  In millionths, as the next two
      Square  : constant Micro range 0 .. Million / 4 :=
        Radians * Radians / Million;
      Shorter : constant Micro range 0 .. 2 * Million :=
        Million - Square / 6 + Square * Square / (120 * Million);
      Chord   : constant Micro range -2 * Longest_Way .. 2 * Longest_Way :=
        Length * Shorter / Million;
      Towards : constant Heading := (From.Angle + Half) mod Full_Turn;
   begin
      return (X => From.X + Chord * Cosine (Towards) / Million,
              Y => From.Y + Chord * Sine (Towards) / Million);
   end Place_After;

   procedure Advance (M : in out Motion; Elapsed : Step) is
      Whole_Turns : constant := 100 * Full_Turn / Turn_Rate;
      --  Microseconds in which the robot turns whole turns whatever its
      --  speed in percent

      Far_Enough : constant := 300 * Million;
      --  Microseconds after which an endless straight run has met a wall
      --  wherever it began: 1.8 m are more than any diagonal
   begin
      if M.Order = None then
         return;
      end if;

      if not M.Endless then
         if Elapsed >= M.Duration - M.Done then
            M.Done := M.Duration;
            Halt (M);
         else
            M.Done := M.Done + Elapsed;
         end if;
      elsif M.Order = Rotation then
         M.Done := (M.Done + Elapsed) mod Whole_Turns;
      else
         M.Done := Micro'Min (M.Done + Elapsed, Far_Enough);
      end if;
   end Advance;

   procedure Begin_Order
     (M      : in out Motion;
      Order  : Order_Kind;
      Value  : Amount;
      Time   : Run_Time;
      Limit  : Travel;
      Errors : Wheel_Errors)
   with
     Pre  => Order /= None,
     Post => Is_Moving (M) = (Value /= 0)
   is
      --  Limit: of a straight order not known yet
   begin
      Halt (M);
      if Value /= 0 then
         M.Order    := Order;
         M.Errors   := Errors;
         M.Endless  := Value in Endless_Forward | Endless_Backward;
         M.Positive := Value > 0;
         M.Duration := Time;
         M.Limit    := Limit;
         M.Done     := 0;
      end if;
   end Begin_Order;

   function Cosine (Angle : Heading) return Micro is
     (Sine ((Angle + Full_Turn / 4) mod Full_Turn));

   function Free_Way
     (From : Pose; Pull : Pull_Angle; Forward : Boolean) return Travel
   with Post => Free_Way'Result in Way
   is
      --  The length of the arc that ends at the first wall
      Sign : constant Micro := (if Forward then 1 else -1);

      function Is_Free (Length : Travel) return Boolean
        with Pre => Length in Way
      is
         --  No wall is where an arc of that length ends
         Place : constant Place_In_Plane :=
           Place_After (From, Pull, Sign * Length);
      begin
         return Place.X in X_Position and then Place.Y in Y_Position;
      end Is_Free;

      Along_X : constant Component := Sign * Cosine (From.Angle);
      Along_Y : constant Component := Sign * Sine (From.Angle);
      Result  : Travel range 0 .. Way'Last := 0;
      Part    : Travel range 0 .. Stride := Stride;
   begin
      if Pull = 0 then
         return Micro'Min
           (Way'Last,
            Micro'Min
              (Room (From.X, X_Position'First, X_Position'Last, Along_X),
               Room (From.Y, Y_Position'First, Y_Position'Last, Along_Y)));
      end if;

      --  An arc can touch a wall and leave it again, so it is followed from
      --  its beginning. What it does within one stride is less than 0.1
      --  micrometres.

      for K in 1 .. Strides loop
         exit when not Is_Free (Result + Stride);
         Result := Result + Stride;
         pragma Loop_Invariant (Result = Micro (K) * Stride);
      end loop;

      for K in 1 .. 10 loop
         pragma Loop_Invariant (Result <= Way'Last - Part);
         Part := Part / 2;
         if Is_Free (Result + Part) then
            Result := Result + Part;
         end if;
      end loop;
      return Result;
   end Free_Way;

   procedure Go
     (M           : in out Motion;
      Millimetres : Amount;
      Errors      : Wheel_Errors := Ideal)
   is
      Time : constant Micro :=
        abs Micro (Millimetres) * Million / Wheel_Speed;
   begin
      Begin_Order (M, Straight, Millimetres, Time, 0, Errors);
      M.Limit := Free_Way (M.From, Errors.Pull, M.Positive);
   end Go;

   procedure Halt (M : in out Motion) is
   begin
      Place (M, Pose_Of (M));
   end Halt;

   procedure Place (M : out Motion; At_Pose : Pose) is
   begin
      M := (From => At_Pose, others => <>);
   end Place;

   function Pose_Of (M : Motion) return Pose is
      Result : Pose := M.From;
   begin
      case M.Order is
         when None =>
            null;

         when Rotation =>
            declare
               --  A finite turn takes a whole number of microseconds, a
               --  little more than its angle needs
               Speed  : constant Micro := Micro (M.Errors.Turn_Speed);
               Turned : constant Heading :=
                 Micro'Min (M.Done * Turn_Rate * Speed / 100, M.Limit)
                 mod Full_Turn;
            begin
               if M.Positive then
                  Result.Angle := (M.From.Angle + Turned) mod Full_Turn;
               else
                  Result.Angle :=
                    (M.From.Angle + (Full_Turn - Turned)) mod Full_Turn;
               end if;
            end;

         when Straight =>
            declare
               Speed  : constant Micro := Micro (M.Errors.Speed);
               Length : constant Micro range 0 .. Way'Last :=
                 Micro'Min
                   (M.Done * Wheel_Speed * Speed / 100_000,
                    Micro'Min (M.Limit, Way'Last));
               Gone   : constant Way :=
                 (if M.Positive then Length else -Length);
               Place  : constant Place_In_Plane :=
                 Place_After (M.From, M.Errors.Pull, Gone);
            begin
               Result.X := Micro'Max
                 (X_Position'First, Micro'Min (X_Position'Last, Place.X));
               Result.Y := Micro'Max
                 (Y_Position'First, Micro'Min (Y_Position'Last, Place.Y));
               Result.Angle :=
                 (M.From.Angle + Micro (M.Errors.Pull) * Gone)
                 mod Full_Turn;
            end;
      end case;
      return Result;
   end Pose_Of;

   function Quarter_Sine (Angle : Quarter) return Fraction is
      --  Of the first quadrant, interpolated between whole degrees
      Whole : constant Micro := Angle / Million;
      Part  : constant Micro := Angle mod Million;
   begin
      if Part = 0 then
         return Sines (Whole);
      else
         return Micro'Min
           (Million,
            (Sines (Whole) * (Million - Part) + Sines (Whole + 1) * Part
             + Million / 2) / Million);
      end if;
   end Quarter_Sine;

   function Sine (Angle : Heading) return Micro is
      Half : constant := Full_Turn / 2;
   begin
      if Angle <= Half / 2 then
         return Quarter_Sine (Angle);
      elsif Angle <= Half then
         return Quarter_Sine (Half - Angle);
      elsif Angle <= Half + Half / 2 then
         return -Quarter_Sine (Angle - Half);
      else
         return -Quarter_Sine (Full_Turn - Angle);
      end if;
   end Sine;

   procedure Turn
     (M       : in out Motion;
      Degrees : Amount;
      Errors  : Wheel_Errors := Ideal)
   is
      Part  : constant Micro range 100 .. 120 :=
        100 + Micro (Errors.Overshoot);
      --  What is turned, in percent
      Angle : constant Micro range 0 .. 32_768 * 120 :=
        abs Micro (Degrees) * Part;
      --  Hundredths of degrees
      Time  : constant Micro :=
        (Angle * (Million / 100) + (Turn_Rate - 1)) / Turn_Rate;
      --  Rounded up: a turn is done when all of its angle is
      Limit : constant Travel :=
        (if Degrees in Endless_Forward | Endless_Backward then Travel'Last
         else Angle * Micro (Errors.Turn_Speed) * (Million / 10_000));
   begin
      Begin_Order (M, Rotation, Degrees, Time, Limit, Errors);
   end Turn;

end Robot_Motion;
