--  SPDX-License-Identifier: GPL-3.0-or-later
--  Where the emulated robot stands: positions along one straight segment
--  at a time, so that rounding does not add up.

package body Robot_Motion with SPARK_Mode is

   Million : constant := 1_000_000;

   subtype Fraction is Micro range 0 .. Million;
   subtype Component is Micro range -Million .. Million;
   subtype Quarter is Micro range 0 .. Full_Turn / 4;
   subtype Travel is Micro range 0 .. Longest_Run * Turn_Rate;

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

   function Quarter_Sine (Angle : Quarter) return Fraction;
   --  Of the first quadrant, interpolated between whole degrees

   function Room
     (Position, Low, High : Micro; Along : Component) return Micro
   with
     Pre  => Low in 0 .. Million
             and then High in Low .. Million
             and then Position in Low .. High,
     Post => Room'Result >= 0;
   --  How far one can travel from Position before the coordinate, which
   --  changes by Along millionths of the travel, leaves Low .. High

   procedure Begin_Order
     (M       : in out Motion;
      Order   : Order_Kind;
      Value   : Amount;
      Endless : Boolean;
      Time    : Run_Time)
   with
     Pre  => Order /= None,
     Post => Is_Moving (M) = (Value /= 0);

   procedure Advance (M : in out Motion; Elapsed : Step) is
      Whole_Turn : constant := Full_Turn / Turn_Rate;
      --  Microseconds for one turn

      Far_Enough : constant := 20 * Million;
      --  Microseconds after which an endless straight run has met a wall
      --  wherever it began: 4 m are more than any diagonal
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
         M.Done := (M.Done + Elapsed) mod Whole_Turn;
      else
         M.Done := Micro'Min (M.Done + Elapsed, Far_Enough);
      end if;
   end Advance;

   procedure Begin_Order
     (M       : in out Motion;
      Order   : Order_Kind;
      Value   : Amount;
      Endless : Boolean;
      Time    : Run_Time) is
   begin
      Halt (M);
      if Value /= 0 then
         M.Order    := Order;
         M.Endless  := Endless;
         M.Positive := Value > 0;
         M.Duration := Time;
         M.Done     := 0;
      end if;
   end Begin_Order;

   function Cosine (Angle : Heading) return Micro is
     (Sine ((Angle + Full_Turn / 4) mod Full_Turn));

   procedure Go (M : in out Motion; Millimetres : Amount) is
      Time : constant Micro :=
        abs Micro (Millimetres) * Million / Wheel_Speed;
   begin
      Begin_Order
        (M, Straight, Millimetres,
         Millimetres in Endless_Forward | Endless_Backward, Time);
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
               Angle : constant Travel := M.Done * Turn_Rate;
               Value : constant Travel :=
                 (if M.Endless then Angle
                  else Micro'Min
                         (Angle, M.Duration * Turn_Rate / Million * Million));
               Turned : constant Heading := Value mod Full_Turn;
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
               Sign    : constant Micro := (if M.Positive then 1 else -1);
               Along_X : constant Component := Sign * Cosine (M.From.Angle);
               Along_Y : constant Component := Sign * Sine (M.From.Angle);
               Wanted  : constant Travel := M.Done * Wheel_Speed / 1_000;
               Way     : constant Travel :=
                 Micro'Min
                   (Wanted,
                    Micro'Min
                      (Room (M.From.X, X_Position'First, X_Position'Last,
                             Along_X),
                       Room (M.From.Y, Y_Position'First, Y_Position'Last,
                             Along_Y)));
            begin
               Result.X := Micro'Max
                 (X_Position'First,
                  Micro'Min (X_Position'Last,
                             M.From.X + Way * Along_X / Million));
               Result.Y := Micro'Max
                 (Y_Position'First,
                  Micro'Min (Y_Position'Last,
                             M.From.Y + Way * Along_Y / Million));
            end;
      end case;
      return Result;
   end Pose_Of;

   function Quarter_Sine (Angle : Quarter) return Fraction is
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

   function Room
     (Position, Low, High : Micro; Along : Component) return Micro is
   begin
      if Along > 0 then
         return (High - Position) * Million / Along;
      elsif Along < 0 then
         return (Position - Low) * Million / (-Along);
      else
         return Micro'Last;
      end if;
   end Room;

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

   procedure Turn (M : in out Motion; Degrees : Amount) is
      Time : constant Micro :=
        (abs Micro (Degrees) * Million + (Turn_Rate - 1)) / Turn_Rate;
      --  Rounded up: a turn is done when all of its angle is
   begin
      Begin_Order
        (M, Rotation, Degrees,
         Degrees in Endless_Forward | Endless_Backward, Time);
   end Turn;

end Robot_Motion;
