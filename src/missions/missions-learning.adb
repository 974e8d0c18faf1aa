--  SPDX-License-Identifier: GPL-3.0-or-later

package body Missions.Learning with SPARK_Mode is

   Learning_Way : constant := 40_000;
   --  Micrometres. Nothing is learnt from shorter drives
   Long_Way     : constant := 100_000;
   --  A surprise in a shorter drive is not believed

   Most_Way  : constant Weight := 600 ** 2;
   Most_Turn : constant Weight := 300 ** 2;
   --  So that what changes later is still learnt

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
         --  With what has been Seen, whose weight is Amount
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

end Missions.Learning;
