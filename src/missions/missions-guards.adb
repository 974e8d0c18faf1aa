--  SPDX-License-Identifier: GPL-3.0-or-later

package body Missions.Guards with SPARK_Mode is

   use Missions.Angles;

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
      Whole : constant Some_Length := True_Length (Move, Doubt.Longest);
   begin
      --  The robot drives an arc. Its end is checked after each quarter of the
      --  way, in three directions: the most likely one, and the farthest to
      --  each side. Within a quarter the arc leaves its chord by less than
      --  Braking

      for K in Micrometres range 1 .. 4 loop
         declare
            Length : constant Some_Length := Whole * K / 4;
            Middle : constant Microdegrees :=
              From.Heading + Swing (Length, Doubt.Likely);
            Spread : constant Microdegrees :=
              Doubt.Heading + abs Swing (Length, Doubt.Either);
         begin
            if not
              (Is_Inside (From.At_Place, Normal (Middle), Length, Size)
               and then Is_Inside
                 (From.At_Place, Normal (Middle - Spread), Length, Size)
               and then Is_Inside
                 (From.At_Place, Normal (Middle + Spread), Length, Size))
            then
               return False;
            end if;
         end;
      end loop;
      return True;
   end Is_Permitted;

end Missions.Guards;
