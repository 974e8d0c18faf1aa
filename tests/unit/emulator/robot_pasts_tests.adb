--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the robot was a while ago.

with Robot_Core;       use Robot_Core;
with Robot_Motion;     use Robot_Motion;
with Robot_Pasts;      use Robot_Pasts;
with Unit_Runs; use Unit_Runs;

procedure Robot_Pasts_Tests is

   subtype Time_Point is Robot_Core.Time_Point;

   procedure Send (R : in out Robot; Text : String) is
      Data     : Octets (1 .. Text'Length);
      Complete : Boolean;
      Result   : Exchange;
   begin
      for K in Data'Range loop
         Data (K) := Character'Pos (Text (Text'First + K - 1));
      end loop;
      for Byte of Octets'(Data & Checksum (Data) & 16#0D#) loop
         Receive (R, Byte, Complete, Result);
      end loop;
      Assert (Complete, "no frame");
   end Send;

   procedure Test_Every_Millisecond is

      type Poses is array (0 .. 9_000) of Robot_Motion.Pose;
      type States is array (Poses'Range) of State_Kind;

      R, Then_It_Was : Robot;
      P              : Past;
      Was_At         : Poses;
      Was            : States;
      Happened       : Boolean;
   begin
      for Time in Poses'Range loop
         Advance_To (R, Time_Point (Time) * 1_000);
         Happened := True;
         case Time is
            when 0      => Switch_On (R, Boot => 1);
            when 200    => Send (R, "W");
            when 300    => Send (R, "T=45");
            when 1_000  => Send (R, "M=32767");
            when 1_333  => Send (R, "v");
            when 1_500  => Place (R, (100_000, 200_000, 77_000_000));
            when 1_700  => Send (R, "M=32767");
            when others => Happened := False;
         end case;
         if Happened then
            Add (P, R);
         end if;
         Was_At (Time) := Robot_Core.Pose (R);
         Was (Time) := State (R);
      end loop;

      --  Between events too: the turn has ended, and nobody reloaded

      Assert (Was (290) = Run and then Was (400) = Movement
              and then Was (900) = Run
              and then Was (9_000) = Watchdog_Disabled, "another story");
      for Time in Poses'Range loop
         Then_It_Was := Robot_At (P, Time_Point (Time) * 1_000);
         Assert (Robot_Core.Pose (Then_It_Was) = Was_At (Time)
                 and then State (Then_It_Was) = Was (Time),
                 "at" & Time'Image);
      end loop;
   end Test_Every_Millisecond;

   procedure Test_Oldest is
      R : Robot;
      P : Past;
   begin
      Assert (Robot_Core.Pose (Robot_At (P, 5)) = Robot_Core.Pose (R),
              "of nothing");
      for K in 1 .. 2 * Capacity loop
         Advance_To (R, Time_Point (K) * 1_000);
         Place (R, (100_000 + Micro (K), 200_000, 0));
         Add (P, R);
         if K = 3 then
            Assert (Robot_Core.Pose (Robot_At (P, 0)).X = 100_001,
                    "before the first");
            Assert (Robot_Core.Pose (Robot_At (P, 2_999)).X = 100_002,
                    "before the third");
         end if;
      end loop;
      for K in 1 .. 2 * Capacity + 1 loop
         Assert (Robot_Core.Pose
                   (Robot_At (P, Time_Point (K) * 1_000)).X
                 = 100_000 + Micro'Min
                     (Micro'Max (Micro (K), Micro (Capacity + 1)),
                      Micro (2 * Capacity)), "at" & K'Image);
      end loop;
   end Test_Oldest;

begin
   Run_Test ("every millisecond", Test_Every_Millisecond'Access);
   Run_Test ("the oldest", Test_Oldest'Access);
end Robot_Pasts_Tests;
