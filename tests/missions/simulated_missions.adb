--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Numerics.Elementary_Functions; use Ada.Numerics.Elementary_Functions;
with Ada.Text_IO;

with GNAT.Random_Numbers; use GNAT.Random_Numbers;

with Missions.Angles;
with Missions.Runs;       use Missions.Runs;
with Robot.Protocol;
with Robot.Session;
with Robot_Core;
with Robot_Pasts;

package body Simulated_Missions is

   use type Missions.Micrometres;
   use type Missions.Microdegrees;
   use type Missions.Microseconds;
   use type Robot_Core.Octet;
   use type Robot_Core.Octets;
   use type Robot_Core.State_Kind;
   use type Robot_Motion.Micro;

   subtype Microseconds is Missions.Microseconds;
   subtype Time_Point is Robot_Core.Time_Point;

   Sample        : constant := 4_000;
   --  of the robot's way
   Byte_Time     : constant := 1_042;     --  at 9600 baud
   Answer_Time   : constant := 80_000;    --  an answer is awaited
   Image_Period  : constant := 100_000;
   Task_Period   : constant := 20_000;
   --  of the supervisor's task, at most
   Longest       : constant := 3_600_000_000;

   Empty_Past : Robot_Pasts.Past;
   Past       : Robot_Pasts.Past;
   --  of the robot, for late images

   function Whole
     (Source : Generator; Low, High : Integer) return Integer
   is (Low + Integer
         (Float'Floor
            (Random (Source) * Float (High - Low + 1) * 0.999_999)));

   function Exact_Time (M : Mission; F : Faults) return Float is
      --  Seconds
      Drive_Speed : constant Float :=
        Float (Robot_Motion.Wheel_Speed) * 10.0 * Float (F.Wheels.Speed);
      --  micrometres a second
      Turn_Speed  : constant Float :=
        Float (Robot_Motion.Turn_Rate) * 10_000.0
        * Float (F.Wheels.Turn_Speed);
      X           : Missions.Micrometres :=
        Missions.Micrometres (M.Start.X);
      Y           : Missions.Micrometres :=
        Missions.Micrometres (M.Start.Y);
      Heading     : Missions.Bearing :=
        Missions.Angles.Normal (Missions.Microdegrees (M.Start.Angle));
      Towards     : Missions.Bearing;
      Dx, Dy      : Missions.Micrometres;
      Sum         : Float := 0.0;
   begin
      for P of M.Targets (1 .. M.Count) loop
         Dx := P.X - X;
         Dy := P.Y - Y;
         if Dx /= 0 or else Dy /= 0 then
            Towards := Missions.Angles.Direction (Dx, Dy);
            Sum := Sum
              + Float (abs Missions.Angles.Normal (Towards - Heading))
                / Turn_Speed
              + Sqrt (Float (Dx) ** 2 + Float (Dy) ** 2)
                / (Drive_Speed);
            Heading := Towards;
         end if;
         X := P.X;
         Y := P.Y;
      end loop;
      return Sum;
   end Exact_Time;

   procedure Make_Faults (Source : Generator; F : out Faults) is
   begin
      F :=
        (Wheels        =>
           (Speed      => Whole (Source, 70, 130),
            Turn_Speed => Whole (Source, 70, 130),
            Overshoot  => Whole (Source, 0, 20),
            Pull       => Whole (Source, -30, 30)),
         Changing      => 0,
         Image_Delay   => Milliseconds (Whole (Source, 0, 150)),
         Place_Noise   => 2.8,
         Heading_Noise => 0.5,
         Lose_Every    => 10);
   end Make_Faults;

   procedure Make_Mission
     (Source : Generator;
      Count  : Missions.Point_Number;
      M      : out Mission)
   is
      Border : constant := 80;
      function Any_X return Integer is (Whole (Source, Border, 800 - Border));
      function Any_Y return Integer is (Whole (Source, Border, 600 - Border));
   begin
      M :=
        (Start  =>
           (X     => Robot_Motion.Micro (Any_X) * 1_000,
            Y     => Robot_Motion.Micro (Any_Y) * 1_000,
            Angle => Robot_Motion.Micro (Whole (Source, 0, 359)) * 1_000_000),
         Count  => Count,
         others => <>);
      for P of M.Targets (1 .. Count) loop
         P := (Missions.Micrometres (Any_X) * 1_000,
               Missions.Micrometres (Any_Y) * 1_000);
      end loop;
   end Make_Mission;

   procedure Simulate
     (M      : Mission;
      F      : Faults;
      Seed   : Integer;
      R      : out Result;
      Traced : Boolean := False;
      Image  : access procedure (Time : Robot_Motion.Time_Point) := null;
      Place  : access procedure
        (Time   : Robot_Motion.Time_Point;
         Where  : Robot_Motion.Pose;
         Moving : Boolean) := null)
   is
      Source       : Generator;
      The_Robot    : Robot_Core.Robot;
      The_Run      : Run;
      Current_Leg  : Missions.Point_Number := 1;
      Passes       : array (1 .. M.Count) of Float := (others => 1.0E9);
      --  Square millimetres
      Captured     : Time_Point;
      Arrives      : Time_Point;
      --  The next image
      Newest       : Sighting;
      Last_Image   : Time_Point := Start_Time;
      Moves_Since  : Time_Point := Start_Time;
      Answers      : Natural;
      Out_Of_Step  : Boolean := False;
      Began        : Time_Point;
      Next         : Action;
      Outcome      : Robot.Session.Outcome;

      function Now return Time_Point is (Robot_Core.Clock (The_Robot));

      function Moves return Boolean is
        (Robot_Core.State (The_Robot) = Robot_Core.Movement);

      procedure Observe is
         --  The robot's place
         P : constant Robot_Motion.Pose := Robot_Core.Pose (The_Robot);
         T : constant Missions.Place := M.Targets (Current_Leg);
         use Robot_Motion;
      begin
         Passes (Current_Leg) := Float'Min
           (Passes (Current_Leg),
            ((Float (P.X) - Float (T.X)) / 1_000.0) ** 2
            + ((Float (P.Y) - Float (T.Y)) / 1_000.0) ** 2);
         R.Room := Millimetres'Min
           (R.Room,
            Millimetres
              (Float (Micro'Min
                 (Micro'Min (P.X - X_Position'First, X_Position'Last - P.X),
                  Micro'Min (P.Y - Y_Position'First, Y_Position'Last - P.Y)))
               / 1_000.0));
         if not Moves then
            Moves_Since := Now;
         end if;
         R.Blind := Milliseconds'Max
           (R.Blind,
            Milliseconds
              (Float (Now - Micro'Max (Moves_Since, Last_Image)) / 1_000.0));
         if Place /= null then
            Place (Now, P, Moves);
         end if;
      end Observe;

      procedure Wait_Until (Time : Time_Point);

      procedure Talk
        (Command : Robot.Protocol.Command;
         Reply   : out Robot_Core.Answer;
         Is_Lost : out Boolean);

      procedure Carry_Out (Request : Robot.Session.Request) is
         Command : constant Robot.Protocol.Command :=
           Robot.Session.Command_For (Request);
         Reply   : Robot_Core.Answer;
         Is_Lost : Boolean;
      begin
         Outcome := (Kind => Robot.Session.Timed_Out, others => <>);
         if Out_Of_Step then
            Talk ((Robot.Protocol.Version, 0), Reply, Is_Lost);
            if Is_Lost then
               return;
            end if;
            Out_Of_Step := False;
         end if;

         Talk (Command, Reply, Is_Lost);
         if Is_Lost then
            Out_Of_Step := True;
         elsif Reply.Data (1) = Character'Pos ('E') then
            Outcome.Kind := Robot.Session.Refused;
         else
            Outcome.Kind := Robot.Session.Done;
            Outcome.Text.Data (1) := Character'Val (Reply.Data (1));
         end if;
      end Carry_Out;

      procedure Move_To (Time : Time_Point) is
      begin
         while Now < Time loop
            Robot_Core.Advance_To
              (The_Robot, Time_Point'Min (Time, Now + Sample));
            Observe;
         end loop;
      end Move_To;

      procedure Note (Text : String) is
      begin
         if Traced then
            declare
               P : constant Robot_Motion.Pose := Robot_Core.Pose (The_Robot);
            begin
               Ada.Text_IO.Put_Line
                 (Robot_Motion.Micro'Image ((Now - Began) / 1_000)
                  & " ms, leg" & Current_Leg'Image & ", at"
                  & Robot_Motion.Micro'Image (P.X / 1_000)
                  & Robot_Motion.Micro'Image (P.Y / 1_000)
                  & Robot_Motion.Micro'Image (P.Angle / 1_000_000)
                  & (if Moves then " moving" else " at rest") & ": " & Text);
            end;
         end if;
      end Note;

      procedure Plan_Image is
      begin
         Captured := Captured + Image_Period;
         Arrives  := Captured
           + Robot_Motion.Micro (Whole (Source, 20_000, 40_000));
      end Plan_Image;

      procedure Talk
        (Command : Robot.Protocol.Command;
         Reply   : out Robot_Core.Answer;
         Is_Lost : out Boolean)
      is
         Number   : constant String := Command.Value'Image;
         Text     : constant String :=
           Robot.Protocol.Letter (Command.Kind)
           & (if Command.Kind not in Robot.Protocol.With_Argument then ""
              elsif Command.Value < 0 then '=' & Number
              else '=' & Number (2 .. Number'Last));
         Data     : Robot_Core.Octets (1 .. Text'Length);
         Complete : Boolean;
         Result   : Robot_Core.Exchange;
         Wheels   : Robot_Motion.Wheel_Errors := F.Wheels;
         Sent     : Time_Point;

         function Changed (Percent : Integer) return Integer is
           (Integer'Max
              (70,
               Integer'Min
                 (130,
                  Percent + Whole (Source, -F.Changing, F.Changing))));
      begin
         if F.Changing > 0 then
            Wheels.Speed := Changed (Wheels.Speed);
            Wheels.Turn_Speed := Changed (Wheels.Turn_Speed);
            Robot_Core.Set_Wheels (The_Robot, Wheels);
         end if;

         for K in Data'Range loop
            Data (K) := Character'Pos (Text (Text'First + K - 1));
         end loop;
         for Byte of Robot_Core.Octets'
           (Data & Robot_Core.Checksum (Data) & 16#0D#)
         loop
            Wait_Until (Now + Byte_Time);
            Robot_Core.Receive (The_Robot, Byte, Complete, Result);
         end loop;
         Robot_Pasts.Add (Past, The_Robot);
         Sent    := Now;
         Reply   := Result.Reply;
         Answers := Answers + 1;
         Is_Lost :=
           F.Lose_Every > 0 and then Answers mod F.Lose_Every = 0;
         if Is_Lost then
            Wait_Until (Sent + Answer_Time);
         else
            Wait_Until
              (Sent + 1_000 + Robot_Motion.Micro (Reply.Length) * Byte_Time);
         end if;
         Note (Text & (if Is_Lost then " (answer lost)" else " -> "
                       & Character'Val (Reply.Data (1))));
      end Talk;

      procedure Wait_Until (Time : Time_Point) is
         P : Robot_Motion.Pose;

         function Noise (Deviation : Float) return Float is
           (Random_Gaussian (Source) * Deviation);
      begin
         while Arrives <= Time loop
            Move_To (Arrives);
            P := Robot_Core.Pose
              (Robot_Pasts.Robot_At
                 (Past,
                  Captured - Robot_Motion.Micro (F.Image_Delay * 1_000)));
            Newest :=
              (Number => Newest.Number + 1,
               Taken  => Microseconds (Captured),
               Seen   => True,
               Where  =>
                 (At_Place =>
                    (Missions.Micrometres (P.X)
                     + Missions.Micrometres (Noise (F.Place_Noise) * 1_000.0),
                     Missions.Micrometres (P.Y)
                     + Missions.Micrometres
                         (Noise (F.Place_Noise) * 1_000.0)),
                  Heading  => Missions.Angles.Normal
                    (Missions.Microdegrees (P.Angle)
                     + Missions.Microdegrees
                         (Noise (F.Heading_Noise) * 1.0E6))));
            Last_Image := Now;
            if Image /= null then
               Image (Now);
            end if;
            Plan_Image;
         end loop;
         Move_To (Time);
      end Wait_Until;

      Complete : Boolean;
      Ignored  : Robot_Core.Exchange;
   begin
      Reset (Source, Seed);
      Answers := Whole (Source, 0, 99);
      R := (Exact  => Milliseconds (Exact_Time (M, F) * 1_000.0),
            Room   => 1_000.0,
            others => <>);
      Robot_Core.Set_Wheels (The_Robot, F.Wheels);
      Robot_Core.Place (The_Robot, M.Start);
      Robot_Core.Switch_On (The_Robot, Boot => 1);
      Robot_Core.Advance_To (The_Robot, Start_Time - 500_000);
      for Byte of Robot_Core.Octets'(Character'Pos ('u'),
                                     Character'Pos ('u'), 16#0D#)
      loop
         Robot_Core.Receive (The_Robot, Byte, Complete, Ignored);
      end loop;
      Past := Empty_Past;
      Robot_Pasts.Add (Past, The_Robot);
      Captured := Start_Time - 250_000
        + Robot_Motion.Micro (Whole (Source, 0, 99_999));
      Plan_Image;
      Wait_Until (Start_Time);
      R.Blind := 0.0;

      Began := Now;
      Start (The_Run, (80, 60), M.Targets, M.Count, Microseconds (Now));
      loop
         See (The_Run, Newest);
         Step (The_Run, Microseconds (Now), Next);
         loop
            Observe;
            exit when Current_Leg = Leg (The_Run);
            Current_Leg := Current_Leg + 1;
         end loop;
         if Has_Ended (The_Run) and then R.Time = 0.0 then
            R.Time := Milliseconds (Float (Now - Began) / 1_000.0);
            Note ("ended: " & Ended_By (The_Run)'Image);
         end if;
         case Next.Kind is
            when Nothing =>
               Wait_Until
                 (Time_Point'Min
                    (Time_Point'Min (Arrives, Now + Task_Period),
                     Time_Point'Max
                       (Now + 500,
                        Time_Point
                          (Next_Look (The_Run, Microseconds (Now))))));

            when Ask | Order | Stop =>
               Carry_Out (Next.Request);
               Tell (The_Run, Outcome, Microseconds (Now));
               if Next.Kind = Order then
                  R.Orders := R.Orders + 1;
               end if;

            when Leave =>
               exit;
         end case;
         if Now > Longest then
            raise Program_Error with "the mission does not end";
         end if;
      end loop;

      Wait_Until (Now + After_The_End);
      R.Ended := Ended_By (The_Run);
      R.Measured := Measured (The_Run);
      R.Worst_Pass := 0.0;
      for P of Passes loop
         R.Worst_Pass := Millimetres'Max
           (R.Worst_Pass,
            Millimetres (Sqrt (Float'Min (P, 1.0E6))));
      end loop;
   end Simulate;

end Simulated_Missions;
