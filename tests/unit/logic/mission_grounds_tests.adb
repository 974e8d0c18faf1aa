--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time;     use Ada.Real_Time;

with Missions;          use Missions;
with Missions.Arenas;
with Missions.Grounds;  use Missions.Grounds;
with Missions.Runs;
with Robot.Session;
with Vision.Mode;
with Vision; use Vision;
with Unit_Runs; use Unit_Runs;

procedure Mission_Grounds_Tests is

   Start : constant Time := Time_First + Seconds (1_000_000);

   Arena : constant Arena_Corners :=
     (Top_Left     => (80_000_000, 60_000_000),
      Top_Right    => (560_000_000, 60_000_000),
      Bottom_Right => (560_000_000, 420_000_000),
      Bottom_Left  => (80_000_000, 420_000_000));
   --  Six pixels a centimetre, for 80 x 60 cm

   Good : constant Ground :=
     (Line => (Held   => (State  => (Line_Open => True,
                                     Mode      => Robot.Session.Started,
                                     others    => <>),
                          others => <>),
               others => <>),
      View =>
        (Vision.Mode.Streaming, True, True, Arena => Arena, others => <>),
      Seen =>
        (Number => 7,
         Came   => Start - Milliseconds (40),
         Seen   => True,
         Robot  => (Centre    => (320_000_000, 240_000_000),
                    Direction => (338_000_000, 240_000_000),
                    others    => <>)),
      Now  => Start);

   Two_Points : constant Path :=
     (Measure => Pixels,
      Count   => 2,
      Points  => (1      => (320_000_000, 180_000_000),
                  2      => (200_000_000, 240_000_000),
                  others => <>));

   procedure Expect
     (G : Ground; P : Path; Places : Place_Array; Reason : String := "")
   is
      --  The mission may begin, and goes to Places, or Reason is against it
      Map       : Missions.Arenas.Map;
      Targets   : Place_Array;
      May_Begin : Boolean;
      Why       : Refusal;
   begin
      Check (G, P, (80, 60), Map, Targets, May_Begin, Why);
      Assert (May_Begin = (Reason = "")
              and then (May_Begin or else Why = Refusal'Value (Reason)),
              May_Begin'Image & ", " & Why'Image & " and not " & Reason);
      for K in 1 .. (if May_Begin then P.Count else 0) loop
         Assert (Targets (K) = Places (K),
                 "a point at" & Targets (K).X'Image & Targets (K).Y'Image);
      end loop;
   end Expect;

   procedure Test_Begins is
   begin
      Expect (Good, Two_Points,
              (1      => (400_000, 400_000),
               2      => (200_000, 300_000),
               others => (0, 0)));
      Expect (Good,
              (Centimetres, 1,
               (1 => (12_500_000, 50_000_000), others => <>)),
              (1 => (125_000, 500_000), others => (0, 0)));
   end Test_Begins;

   procedure Test_Refused is
      G : Ground := Good;
      P : Path   := Two_Points;

      procedure Refuse (Reason : String) is
      begin
         Expect (G, P, (others => (0, 0)), Reason);
      end Refuse;

   begin
      P.Points (2) := (85_000_000, 240_000_000);
      Refuse ("Point_Outside");
      G.Seen.Came := Start - Milliseconds (301);
      Refuse ("Robot_Not_Seen");
      G := Good;
      G.Seen.Seen := False;
      Refuse ("Robot_Not_Seen");
      --  the reasons in their order

      for C in Corner loop
         G.View.Arena (C) := (Arena (C).X / 6, Arena (C).Y / 6);
      end loop;
      Refuse ("Arena_Too_Small");
      G.View.Confirmed := False;
      Refuse ("Arena_Not_Confirmed");
      G.View.Stage := Vision.Mode.Deciding;
      G.View.Confirmed := True;
      Refuse ("Arena_Not_Confirmed");
      G.View.Position_On := False;
      Refuse ("Positions_Off");
      G.View := (others => <>);
      Refuse ("Camera_Closed");
      G.Line := (others => <>);
      Refuse ("Robot_Not_Started");
   end Test_Refused;

   procedure Test_Times is
      Hours : constant Time := Start + Seconds (50_000) + Milliseconds (3);
   begin
      Assert (Since (Start, Start) = Lead, "the beginning");
      Assert (Since (Start, Start - Milliseconds (40)) = Lead - 40_000,
              "an image before it");
      Assert (Since (Start, Start - Seconds (2)) = 0, "long before");
      Assert (Since (Start, Time_First) = 0, "no image");
      Assert (Since (Start, Hours) = Lead + 50_000_003_000, "hours after");

      Assert (Next_Time (Start, Hours, Since (Start, Hours) + 5_000)
              = Hours + Milliseconds (5), "due before the period ends");
      Assert (Next_Time (Start, Hours, Since (Start, Hours) + 500_000)
              = Hours + Milliseconds (20), "due after it");
      Assert (Next_Time (Start, Hours, Since (Start, Hours) + 10 ** 12)
              = Hours + Milliseconds (20), "due in days");
      Assert (Next_Time (Start, Hours, 0) = Hours, "overdue");
   end Test_Times;

   procedure Test_Seen is
      Map    : Missions.Arenas.Map;
      Usable : Boolean;
      G      : Ground := Good;
      Seen   : Missions.Runs.Sighting;
   begin
      Missions.Arenas.Make (Arena, (80, 60), Map, Usable);
      Assert (Usable, "the arena is not usable");
      Seen := Seen_From (Start, Map, G);
      Assert (Seen.Seen and then Seen.Number = 7, "not seen");
      Assert (Seen.Taken = Lead - 40_000, "at" & Seen.Taken'Image);
      Assert (Seen.Where.At_Place = (400_000, 300_000), "elsewhere");
      Assert (abs Seen.Where.Heading < 1_000, "it heads elsewhere");
      G.Seen.Seen := False;
      Seen := Seen_From (Start, Map, G);
      Assert (not Seen.Seen and then Seen.Number = 7, "seen");
   end Test_Seen;

begin
   Run_Test ("a mission that may begin", Test_Begins'Access);
   Run_Test ("each reason against it", Test_Refused'Access);
   Run_Test ("its times, over many hours", Test_Times'Access);
   Run_Test ("the robot in the arena", Test_Seen'Access);
end Mission_Grounds_Tests;
