--  SPDX-License-Identifier: GPL-3.0-or-later

package body Missions.Driving with SPARK_Mode is

   Far : constant Micrometres := 100_000_000;
   --  Outside of every arena

   function Is_Inside (From, To : Micrometres; Side : Arena_Side)
     return Boolean
   is (To >= Micrometres'Min (Margin, From)
       and then To <=
         Micrometres'Max (Micrometres (Side) * 10_000 - Margin, From));

   function Is_Inside
     (From : Place; Towards : Bearing; Length : Some_Length;
      Size : Arena_Size) return Boolean
   is
      --  After Length in that direction
      X : constant Micrometres :=
        Micrometres (Wide (Length) * Cosine (Towards) / Million);
      Y : constant Micrometres :=
        Micrometres (Wide (Length) * Sine (Towards) / Million);
   begin
      return abs From.X <= Far
        and then abs From.Y <= Far
        and then Is_Inside (From.X, From.X + X, Size.Width)
        and then Is_Inside (From.Y, From.Y + Y, Size.Height);
   end Is_Inside;

   function Is_Permitted
     (From  : Pose;
      Move  : Drive_Length;
      Doubt : Doubts;
      Size  : Arena_Size) return Boolean
   is
      --  The robot drives an arc. Its end is checked after each quarter of the
      --  way, in three directions: the most likely one, and the farthest to
      --  each side. Within a quarter the arc leaves its chord by less than
      --  Braking
      Whole : constant Some_Length := True_Length (Move, Doubt.Longest);

      function Is_Inside_After (Length : Some_Length) return Boolean is
         Middle : constant Microdegrees :=
           From.Heading + Swing (Length, Doubt.Likely);
         Spread : constant Microdegrees :=
           Doubt.Heading + abs Swing (Length, Doubt.Either);
      begin
         return
           (for all Side in Microdegrees range -1 .. 1 =>
              Is_Inside
                (From.At_Place, Normal (Middle + Side * Spread), Length,
                 Size));
      end Is_Inside_After;

   begin
      return
        (for all K in Micrometres range 1 .. 4 =>
           Is_Inside_After (Whole * K / 4));
   end Is_Permitted;

   Learning_Way : constant := 40_000;
   --  Micrometres. Nothing is learnt from shorter drives
   Long_Way     : constant := 100_000;
   --  An unexpected result of a shorter drive is no reason for checks

   Most_Way  : constant Weight := 600 ** 2;
   Most_Turn : constant Weight := 300 ** 2;
   --  Bounds, so that later changes are still learnt

   Surprise  : constant := 4_000_000;
   --  Microdegrees: deviation of the heading after a drive, in addition to
   --  what 5 mm sideways at its end amount to

   Same_Place   : constant := 9_000;
   Same_Heading : constant := 3_000_000;
   --  An image within these limits shows the same place as the mean

   Side_Way  : constant := 2_500;
   --  Micrometres. The robot does not turn if it would pass the target by less

   First_Way : constant := 200;
   --  Millimetres of the first drive: short, so that its result is seen in
   --  time even if the robot is slow

   procedure Add_Place (R : in out Resting; Where : Near_Pose) is

      function Mean_Of (Mean, Newest : Near) return Near is
        (Near_Of (Mean + (Newest - Mean) / Micrometres (R.Count)))
      with Pre => R.Count > 0;

   begin
      R.Count  := Natural'Min (R.Count + 1, Max_Images);
      R.Mean.X := Mean_Of (R.Mean.X, Where.X);
      R.Mean.Y := Mean_Of (R.Mean.Y, Where.Y);
   end Add_Place;

   procedure Add_Image (R : in out Resting; Where : Near_Pose) is
      Turn    : constant Bearing :=
        Difference (R.Mean.Heading, Where.Heading);
      Is_Same : constant Boolean :=
        Way (R.Mean, Where) <= Same_Place and then abs Turn <= Same_Heading;
   begin
      if R.Count > 0 and then Is_Same then
         Add_Place (R, Where);
         R.Mean.Heading :=
           Normal (R.Mean.Heading + Turn / Microdegrees (R.Count));
      else
         R := (Count     => 1,
               Mean      => Where,
               Expected  => R.Expected,
               Confirmed =>
                 R.Count = 0 and then R.Expected and then Is_Same);
      end if;
   end Add_Image;

   function After_Drive
     (K : Knowledge; From : Near_Pose; Driven : Drive_Length)
      return Near_Pose
   is
      Length : constant Some_Length  := True_Length (Driven, K.Drives);
      Half   : constant Microdegrees := Swing (Length, K.Pulled);
      Chord  : constant Bearing      := Normal (From.Heading + Half);
   begin
      return
        (X       => Near_Of
           (From.X + Micrometres (Wide (Length) * Cosine (Chord) / Million)),
         Y       => Near_Of
           (From.Y + Micrometres (Wide (Length) * Sine (Chord) / Million)),
         Heading => Normal (Chord + Half));
   end After_Drive;

   procedure Choose
     (Here, Goal : Near_Pose;
      K          : Knowledge;
      Turned     : Degrees;
      Turns_Made : Turn_Count;
      Size       : Arena_Size;
      Movement   : out Movement_Kind;
      Amount     : out Drive_Length)
   is
      Towards : constant Bearing     :=
        Direction (Goal.X - Here.X, Goal.Y - Here.Y);
      Ahead   : constant Micrometres :=
        Micrometres'Max (0, Way (Here, Goal));
      Is_Back : constant Boolean     :=
        abs Difference (Here.Heading, Towards) > Half_Turn / 2;
      --  backward, where that means less turning
      Front   : constant Bearing     :=
        (if Is_Back then Normal (Towards + Half_Turn) else Towards);

      subtype Forward_Length is Drive_Length range 0 .. Drive_Length'Last;

      function Signed (Length : Forward_Length) return Drive_Length is
        (if Is_Back then -Length else Length);

      function Course (Length : Forward_Length) return Bearing is
        (Normal
           (Front
            - Swing (True_Length (Signed (Length), K.Drives), K.Pulled)));

      function Is_Good
        (Length : Forward_Length; Heading : Bearing) return Boolean
      is (Is_Permitted
            (((Here.X, Here.Y), Heading), Signed (Length),
             Doubts_Of (K, Turned), Size));

      Wanted  : constant Wide :=
        (Wide (Ahead) * 10 + Wide (K.Drives) / 2) / Wide (K.Drives);
      Length  : Forward_Length :=
        Forward_Length
          (Within
             (Wanted, 1,
              (if not Knows_Way (K) then First_Way
               else Wide (Forward_Length'Last))));
      Angle   : Bearing;
      Half    : Wide;
      Ordered : Degrees;

      procedure Shorten (Aimed : Boolean) is
         --  Length, until the drive is permitted: after the turn if Aimed,
         --  otherwise with the present heading. 0: it never is
      begin
         while Length > 0
           and then not Is_Good
             (Length, (if Aimed then Course (Length) else Here.Heading))
         loop
            pragma Loop_Variant (Decreases => Length);
            Length := Length - Integer'Max (1, Length / 16);
         end loop;
      end Shorten;

   begin
      Movement := Halt;
      Amount := 0;
      Shorten (Aimed => True);
      if Length = 0 then
         return;
      end if;

      Angle   := Difference (Here.Heading, Course (Length));
      Half    := Wide (K.Turns) / 2;
      Ordered := Degrees
        (Within
           ((Wide (Angle) / 100 + (if Angle < 0 then -Half else Half))
            / Wide (K.Turns),
            Wide (Degrees'First), Wide (Degrees'Last)));
      if Ordered /= 0
        and then
          (abs Angle > Half_Turn / 4
           or else abs (Wide (Ahead) * Sine (Angle) / Million) > Side_Way)
        and then abs Angle >
          (if Turns_Made = 2 then 4_000_000
           elsif not Knows_Way (K) then 3_000_000
           elsif Turns_Made = 1 then 1_000_000
           else 0)
      then
         Movement := Turn;
         Amount := Ordered;
         return;
      end if;

      Shorten (Aimed => False);
      if Length > 0 then
         Movement := Drive;
         Amount := Signed (Length);
      elsif Ordered /= 0 then
         Movement := Turn;
         Amount := Ordered;
      end if;
   end Choose;

   procedure Compare
     (K        : Knowledge;
      M        : Movements;
      Now      : Near_Pose;
      Amiss    : out Movement_Kind;
      Measured : out Percent;
      Is_Above : out Boolean)
   is
      Drives : constant Boolean := M.Driven /= 0;
      Seen   : constant Wide :=
        (if Drives then Wide (Way (M.From, Now))
         else Wide (Turn_Seen (K, M, Now)) * (if M.Turned < 0 then -1 else 1));
      Asked  : constant Wide :=
        (if Drives then abs Wide (M.Driven) * 1_000
         else abs Wide (M.Turned) * Million);
      Slack  : constant Wide := (if Drives then Upset_Way else Surprise);
      Still  : constant Wide := (if Drives then 1_000 else Million);
      --  Less than this is measured on a robot at rest
   begin
      Amiss :=
        (if Seen + Slack >= Asked * Wide (Gain'First) / 10_000
           and then Seen - Slack <= Asked * Wide (Gain'Last) / 10_000
         then Halt
         elsif Drives then Drive
         else Turn);
      Measured := Percent
        (Within
           ((if Seen < Still then 0 else Seen * 100 / Wide'Max (1, Asked)),
            0, Wide (Percent'Last)));
      Is_Above := Seen > Asked;
   end Compare;

   procedure Learn
     (K : in out Knowledge; M : Movements; Now : Near_Pose)
   is

      subtype Square is Wide range 1 .. 25_000_000;

      function Square_Of (Amount : Drive_Length) return Square is
        (Within (Wide (Amount) * Wide (Amount), Square'First, Square'Last));

      function Quarter_Of (Number : Square) return Square is
        (Wide'Max (1, Number / 4));

      procedure Average
        (Value     : in out Integer;
         W         : in out Weight;
         Low, High : Integer;
         Seen      : Wide;
         Amount    : Square;
         Most      : Weight)
      with
        Pre  => Low in -100_000 .. High
          and then High <= 100_000
          and then Value in Low .. High,
        Post => Value in Low .. High
      is
         --  Value, with what has been Seen, whose weight is Amount
         Known : constant Wide := Wide (Value);
         Gap   : constant Wide :=
           Within (Seen, Wide (Low), Wide (High)) - Known;
      begin
         Value := Integer
           (Within
              (Known + Gap * Amount / (Wide (W) + Amount),
               Wide (Low), Wide (High)));
         W := Weight (Wide'Min (Wide (Most), Wide (W) + Amount));
      end Average;

      Expected : constant Some_Turn := True_Turn (M.Turned, K.Turns);
      Length   : constant Micrometres := Way (M.From, Now);
      Chord    : constant Bearing :=
        Normal
          (Direction (Now.X - M.From.X, Now.Y - M.From.Y)
           + (if M.Driven < 0 then Half_Turn else 0));
      Before    : Bearing;
      --  the heading at the beginning of the drive
      Error     : Bearing;
      Seen_Gain : Wide;
   begin
      if M.Driven = 0 then
         if M.Turned /= 0 then
            Error := Turn_Error (K, M, Now);
            if Knows_Turn (K) and then abs Error > Surprise then
               K.Distrust := Distrusted;
            end if;
            Average
              (K.Turns, K.Turn_Weight, Gain'First, Gain'Last,
               Wide (Expected + Error) / (Wide (M.Turned) * 100),
               Square_Of (M.Turned), Most_Turn);
            if Knows_Turn (K) and then K.Distrust > 0 then
               K.Distrust := K.Distrust - 1;
            end if;
         end if;
         return;
      elsif Length < Learning_Way then
         return;
      end if;

      Seen_Gain := Within
        (Wide (Length) * 10 / abs Wide (M.Driven), 0, 30_000);
      if Length >= Long_Way and then Knows_Way (K) then
         K.Way_Doubt := Integer'Min
           (50,
            Integer'Max
              (K.Way_Doubt * 15 / 16,
               Integer (abs (Seen_Gain - Wide (K.Drives))) * 250 / K.Drives));
      end if;
      Average
        (K.Drives, K.Way_Weight, Gain'First, Gain'Last, Seen_Gain,
         Square_Of (M.Driven), Most_Way);

      Before :=
        (if M.Turned = 0 then M.From.Heading
         else Normal (Chord + Difference (Now.Heading, Chord)));
      Error :=
        Normal (Before - M.From.Heading - Normal (Expected));
      if M.Turned /= 0 then
         Average
           (K.Turns, K.Turn_Weight, Gain'First, Gain'Last,
            Wide (Expected + Error) / (Wide (M.Turned) * 100),
            Quarter_Of (Square_Of (M.Turned)), Most_Turn);
      end if;
      if Length >= Long_Way
        and then abs Error >
          Surprise + 5_000 * 57_000_000 / Microdegrees (Length)
      then
         K.Distrust := Distrusted;
      end if;

      Average
        (K.Pulled, K.Pull_Weight, Pull'First, Pull'Last,
         Wide (Difference (Before, Now.Heading)) * 1_000
         / Wide (if M.Driven < 0 then -Length else Length),
         (if M.Turned = 0 then Square_Of (M.Driven)
          else Quarter_Of (Square_Of (M.Driven))),
         Most_Way);
   end Learn;

   procedure Learn_Lag
     (K : in out Knowledge; Part : Turn_Part; Turned : Microdegrees)
   is
      Shown : constant Wide :=
        Wide (abs Part.Turned)
        * Wide (Microseconds'Min (Part.Ended, 10 ** 8))
        / Wide'Max (1, Wide (abs Turned));
      --  the time of the turn that was seen
      Lag   : constant Microseconds :=
        (if Shown in 0 .. Wide (Part.Seen)
         then Microseconds'Min (Part.Seen - Microseconds (Shown), Max_Age)
         else 0);
   begin
      if Part.Turned /= 0 then
         K.Lag := (if K.Lag = 0 then Lag else (K.Lag + Lag) / 2);
      end if;
   end Learn_Lag;

end Missions.Driving;
