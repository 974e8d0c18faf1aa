--  SPDX-License-Identifier: GPL-3.0-or-later
--  What can be chosen of the robot, its line and its camera.

with Ada.Strings;           use Ada.Strings;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Maps;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Answer_Faults;
with Arena_Camera;
with Plain_Numbers;         use Plain_Numbers;
with Robot_Bench;           use Robot_Bench;
with Robot_Motion;          use Robot_Motion;

package body Settings is

   type Row is record
      Name, Value, Help : Unbounded_String;
      --  Name: "" where it is set together with another
      Low, High         : Integer := 0;
   end record;

   function "+" (Text : String) return Unbounded_String
     renames To_Unbounded_String;

   Most : constant := Answer_Faults.Remaining'Last;

   Table : constant array (Kind) of Row :=
     (Silent         => (+"silent", +"", +"answers nothing", 0, 1),
      Endless        =>
        (+"endless", +"", +"the next answer does not end", 0, 1),
      Lose           =>
        (+"lose", +"N", +"the next N commands do not arrive", 0, Most),
      Lose_Every     =>
        (+"lose-every", +"N", +"every Nth does not", 0, 1_000),
      Drop           =>
        (+"drop", +"N", +"the next N answers are lost", 0, Most),
      Drop_Every     => (+"drop-every", +"N", +"every Nth is", 0, 1_000),
      Garbage        =>
        (+"garbage", +"N", +"... are random bytes instead", 0, Most),
      Truncate       =>
        (+"truncate", +"N [KEEP]",
         +"... lack their end, or are cut after KEEP bytes", 0, Most),
      Corrupt        =>
        (+"corrupt", +"N", +"... have a wrong checksum", 0, Most),
      Flip           =>
        (+"flip", +"N [BIT]",
         +"... have one bit flipped, each its next", 0, Most),
      Wrong          =>
        (+"wrong", +"N", +"... answer another question", 0, Most),
      Pile           =>
        (+"pile", +"N", +"... are held, and come with the last",
         0, Answer_Faults.Max_Pile),
      Kept_Bytes     => (Low => 0, High => Robot_Core.Answer_Length'Last,
                         others => <>),
      Bit            => (Low => 0, High => Answer_Faults.Bit_Number'Last,
                         others => <>),
      Answer_Delay   =>
        (+"delay", +"MS", +"every answer is late", 0, 60_000),
      Radio_Losses   =>
        (+"radio-losses", +"N", +"percent of packets lost, each direction",
         0, 100),
      Radio_Bursts   =>
        (+"radio-bursts", +"N", +"percent that begin a burst of 8", 0, 100),
      Radio_Retries  =>
        (+"radio-retries", +"N", +"percent of attempts repeated, 30 ms each",
         0, 100),
      Battery        =>
        (+"battery", +"LEVEL",
         +"0, 1, 2, critical (off in 4 s), or 2.5 to 5.0 V", 250, 500),
      Charge         => (+"charge", +"", +"the charger is plugged in", 0, 1),
      Speed          =>
        (+"speed", +"N", +"percent straight on",
         Speed_Percent'First, Speed_Percent'Last),
      Turn_Speed     =>
        (+"turn-speed", +"N", +"percent of turns",
         Speed_Percent'First, Speed_Percent'Last),
      Overshoot      =>
        (+"overshoot", +"N", +"turns go on, and last, by N percent",
         Overshoot_Percent'First, Overshoot_Percent'Last),
      Pull           =>
        (+"pull", +"N", +"degrees to the left per metre",
         Pull_Angle'First, Pull_Angle'Last),
      Camera_Fps     => (+"camera-fps", +"N", +"images a second", 1, 240),
      Camera_Opening =>
        (+"camera-opening", +"MS", +"it takes so long to open", 0, 60_000),
      Camera_Delay   =>
        (+"camera-delay", +"MS", +"images show the robot so long ago",
         0, 1_000),
      Position_Noise =>
        (+"position-noise", +"PX", +"displaces the robot in each image",
         0, 10),
      Noise          =>
        (+"noise", +"N", +"grey levels, standard deviation", 0, 30),
      Marker         => (+"marker", +"KIND", +"aruco or triangle", 0, 1),
      Marker_Id      => (+"marker-id", +"N", +"of an ArUco marker", 0, 999),
      Frame_Width    => (Low => 1, High => 4_096, others => <>),
      Frame_Height   => (Low => 1, High => 2_304, others => <>),
      Camera_Mode    => (others => <>));

   Commas : constant Maps.Character_Mapping := Maps.To_Mapping (",", " ");

   function Battery_Of (Text : String) return Integer is
      Volts : Float;
   begin
      for Level in Robot_Core.Battery_Level loop
         if Text = (case Level is
                       when Robot_Core.Critical => "critical",
                       when Robot_Core.Empty    => "0",
                       when Robot_Core.Low      => "1",
                       when Robot_Core.Full     => "2")
         then
            return Robot_Core.Typical (Level);
         end if;
      end loop;
      Volts := Float'Value (Text);
      if Volts in 2.5 .. 5.0 then
         return Integer (100.0 * Volts);
      end if;
      raise Constraint_Error;
   exception
      when Constraint_Error =>
         raise Bad_Value with
           To_String (Table (Battery).Help) & ", not '" & Text & "'";
   end Battery_Of;

   function One_Of (First, Second, Text : String) return Integer is
      --  0 or 1
   begin
      if Text not in First | Second then
         raise Bad_Value with
           First & " or " & Second & " is expected, not '" & Text & "'";
      end if;
      return Boolean'Pos (Text = Second);
   end One_Of;

   procedure Set_Pose (Text : String) is
      --  X Y HEADING: centimetres from the left and from the bottom wall,
      --  degrees counter-clockwise from the x axis
      Words   : constant String := Translate (Text, Commas);
      Stop    : constant Natural := Index (Words, " ");
      Last    : constant Natural := Index (Words, " ", Backward);
      X, Y, A : Long_Float;
   begin
      X := Long_Float'Value (Words (Words'First .. Stop - 1));
      Y := Long_Float'Value (Words (Stop + 1 .. Last - 1));
      A := Long_Float'Value (Words (Last + 1 .. Words'Last));
      Bench.Place
        ((X     => Micro (X * 10_000.0),
          Y     => Micro (Y * 10_000.0),
          Angle => Micro (A * 1_000_000.0) mod Full_Turn));
   exception
      when Constraint_Error =>
         raise Bad_Value with
           "X Y HEADING are expected, the robot's body inside the arena, in cm"
           & " and degrees, not '" & Text & "'";
   end Set_Pose;

   function Names (Before : String) return String is
      Result : Unbounded_String;

      procedure Add (Name, Value, Help : String) is
      begin
         Append
           (Result,
            Head (Before & Name & " " & Value, 21) & "  " & Help & ASCII.LF);
      end Add;

   begin
      for K in Kind loop
         declare
            R : Row renames Table (K);
         begin
            if R.Name /= "" then
               Add
                 (To_String (R.Name), To_String (R.Value),
                  To_String (R.Help)
                  & (if K in Switch | Battery | Marker or else R.High = Most
                     then ""
                     else ", " & Image (R.Low) & " to " & Image (R.High)
                       & " (" & Image (Usual (K)) & ")"));
            end if;
         end;
      end loop;
      Add ("pose", "X,Y,A", "where it stands: cm, degrees (40,30,0)");
      Add ("frame-size", "WxH", "of images, 1x1 to 4096x2304 (640x480)");
      return To_String (Result);
   end Names;

   procedure Set (Name, Text : String; Known : out Boolean) is

      procedure Set_One (K : Kind; Text : String) is
         Value : constant Integer :=
           (case K is
               when Switch  =>
                 (if Text = "" then 1 else One_Of ("off", "on", Text)),
               when Battery => Battery_Of (Text),
               when Marker  => One_Of ("aruco", "triangle", Text),
               when others  => Whole (Text, Table (K).Low, Table (K).High));
      begin
         if Value = 1 and then K in Lose_Every | Drop_Every then
            raise Bad_Value with "0, or 2 to 1000 is expected";
         elsif K in Camera_Kind then
            Arena_Camera.Set (K, Value);
         else
            Bench.Set (K, Value);
         end if;
      end Set_One;

      Stop  : constant Natural := Index (Text & " ", " ");
      --  behind the first word
      Cross : constant Natural := Index (Text, "x");
   begin
      Known := True;
      if Name = "pose" then
         Set_Pose (Text);
         return;
      elsif Name in "frame-size" | "camera-size" then
         if Cross = 0 then
            raise Bad_Value with
              "WIDTHxHEIGHT is expected, not '" & Text & "'";
         end if;
         Set_One (Frame_Width, Text (Text'First .. Cross - 1));
         Set_One (Frame_Height, Text (Cross + 1 .. Text'Last));
         return;
      end if;
      for K in Kind loop
         if Table (K).Name = Name then
            if K in Truncate | Flip then
               if Stop < Text'Last then
                  Set_One ((if K = Flip then Bit else Kept_Bytes),
                           Trim (Text (Stop .. Text'Last), Both));
               elsif K = Truncate then
                  Set_One (Kept_Bytes, "0");
               end if;
               Set_One (K, Text (Text'First .. Stop - 1));
            else
               Set_One (K, Text);
            end if;
            return;
         end if;
      end loop;
      Known := False;
   end Set;

   function Whole (Text : String; Low, High : Integer) return Integer is
      Value : Integer;
   begin
      if Text'Length > 0
        and then (for all C of Text => C in '0' .. '9' | '-')
      then
         Value := Integer'Value (Text);
         if Value in Low .. High then
            return Value;
         end if;
      end if;
      raise Constraint_Error;
   exception
      when Constraint_Error =>
         raise Bad_Value with
           "a number from " & Image (Low) & " to " & Image (High)
           & " is expected, not '" & Text & "'";
   end Whole;

end Settings;
