--  SPDX-License-Identifier: GPL-3.0-or-later

with Commands;
with GNAT.Random_Numbers; use GNAT.Random_Numbers;

with Missions.Angles;
with Missions.Runs;       use Missions.Runs;
with Monitor.Notices;
with Robot.Protocol;
with Robot.Session;
with Robot_Core;
with Robot_Motion;
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

   Start_Time    : constant Time_Point := 1_000_000;
   --  of each mission
   After_The_End : constant Time_Point := 300_000;

   --  Of images, where Faulty

   Place_Noise   : constant := 2.8;
   --  millimetres: of the emulator's 2 pixels
   Heading_Noise : constant := 0.5;
   --  degrees

   Empty_Past : Robot_Pasts.Past;
   Past       : Robot_Pasts.Past;
   --  of the robot, for late images

   function Whole
     (Source : Generator; Low, High : Integer) return Integer
   is (Low + Integer
         (Float'Floor
            (Random (Source) * Float (High - Low + 1) * 0.999_999)));

   procedure Simulate
     (P        : Plan;
      R        : out Result;
      Changing : Natural := 0)
   is
      Source       : Generator;
      The_Robot    : Robot_Core.Robot;
      The_Run      : Run;
      J            : Judge;
      Captured     : Time_Point;
      Arrives      : Time_Point;
      --  The next image
      Newest       : Sighting;
      Answers      : Natural;
      Out_Of_Step  : Boolean := False;
      Began        : Time_Point;
      Orders       : Natural := 0;
      Ended        : Duration := 0.0;
      Next         : Action;
      Outcome      : Commands.Outcome;

      function Now return Time_Point is (Robot_Core.Clock (The_Robot));

      function Moves return Boolean is
        (Robot_Core.State (The_Robot) = Robot_Core.Movement);

      function Seconds return Duration is
        (Duration (Now - Start_Time) / 1_000_000);

      procedure Observe is
         --  The robot's place
      begin
         See_Pose (J, Seconds, Robot_Core.Pose (The_Robot), Moves);
      end Observe;

      procedure Move_To (Time : Time_Point) is
      begin
         while Now < Time loop
            Robot_Core.Advance_To
              (The_Robot, Time_Point'Min (Time, Now + Sample));
            Observe;
         end loop;
      end Move_To;

      procedure Plan_Image is
      begin
         Captured := Captured + Image_Period;
         Arrives  := Captured
           + Robot_Motion.Micro (Whole (Source, 20_000, 40_000));
      end Plan_Image;

      procedure Wait_Until (Time : Time_Point) is
         Where : Robot_Motion.Pose;

         function Noise (Deviation : Float) return Float is
           (Random_Gaussian (Source) * (if P.Faulty then Deviation else 0.0));
      begin
         while Arrives <= Time loop
            Move_To (Arrives);
            Where := Robot_Core.Pose
              (Robot_Pasts.Robot_At
                 (Past,
                  Captured - (if P.Faulty then Camera_Delay * 1_000 else 0)));
            Newest :=
              (Number => Newest.Number + 1,
               Taken  => Microseconds (Captured),
               Seen   => True,
               Where  =>
                 (At_Place =>
                    (Missions.Micrometres (Where.X)
                     + Missions.Micrometres (Noise (Place_Noise) * 1_000.0),
                     Missions.Micrometres (Where.Y)
                     + Missions.Micrometres (Noise (Place_Noise) * 1_000.0)),
                  Heading  => Missions.Angles.Normal
                    (Missions.Microdegrees (Where.Angle)
                     + Missions.Microdegrees
                         (Noise (Heading_Noise) * 1.0E6))));
            See_Position (J, Seconds);
            Plan_Image;
         end loop;
         Move_To (Time);
      end Wait_Until;

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
         Wheels   : Robot_Motion.Wheel_Errors := P.Wheels;
         Sent     : Time_Point;

         function Changed (Percent : Integer) return Integer is
           (Integer'Max
              (70,
               Integer'Min
                 (130,
                  Percent + Whole (Source, -Changing, Changing))));
      begin
         if Changing > 0 then
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
         Is_Lost := P.Faulty and then Answers mod Drop_Every = 0;
         if Is_Lost then
            Wait_Until (Sent + Answer_Time);
         else
            Wait_Until
              (Sent + 1_000 + Robot_Motion.Micro (Reply.Length) * Byte_Time);
         end if;
      end Talk;

      procedure Carry_Out (Request : Commands.Request) is
         Command : constant Robot.Protocol.Command :=
           Robot.Session.Command_For (Request);
         Reply   : Robot_Core.Answer;
         Is_Lost : Boolean;
      begin
         Outcome := (Kind => Commands.Timed_Out, others => <>);
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
            Outcome.Kind := Commands.Refused;
         else
            Outcome.Kind := Commands.Done;
            Outcome.Text.Data (1) := Character'Val (Reply.Data (1));
         end if;
      end Carry_Out;

      Targets  : Missions.Place_Array;
      Complete : Boolean;
      Ignored  : Robot_Core.Exchange;
   begin
      for K in 1 .. P.Count loop
         Targets (K) :=
           (Missions.Micrometres (P.Points (K).X),
            Missions.Micrometres (P.Points (K).Y));
      end loop;
      Start (J, P);
      Reset (Source, P.Number);
      Answers := Whole (Source, 0, 99);
      Robot_Core.Set_Wheels (The_Robot, P.Wheels);
      Robot_Core.Place (The_Robot, P.Start);
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

      Began := Now;
      Start (The_Run, (80, 60), Targets, P.Count, Microseconds (Now));
      loop
         See (The_Run, Newest);
         Step (The_Run, Microseconds (Now), Next);
         Observe;
         if Has_Ended (The_Run) and then Ended = 0.0 then
            Ended := Duration (Now - Began) / 1_000_000;
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
                  Orders := Orders + 1;
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
      Conclude
        (J, P, Monitor.Notices.Text_Of (R.Ended), Ended, Orders, R.Verdict);
   end Simulate;

end Simulated_Missions;
