--  SPDX-License-Identifier: GPL-3.0-or-later

package body Missions.Runs.Looks with SPARK_Mode is

   --  Micrometres and microdegrees

   Progress_Way  : constant := 10_000;
   Progress_Turn : constant := 5_000_000;
   --  A robot that has got no further makes no progress

   Same_Place   : constant := 9_000;
   Same_Heading : constant := 3_000_000;
   Upset_Way    : constant := 15_000;
   --  Distance from the mean place: more in a turn means that the robot was
   --  moved

   Good_Part    : constant := 20_000_000;
   --  A turn seen halfway has turned so far at least, and four times this at
   --  most: its rate is learnt from that

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

   procedure Arrive (R : in out Run; Now : Microseconds) is
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

   procedure Compare (R : in out Run) is
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

end Missions.Runs.Looks;
