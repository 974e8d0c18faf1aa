--  SPDX-License-Identifier: GPL-3.0-or-later
--  A mission's picture.

with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Ada.Text_IO;       use Ada.Text_IO;

with Instants;          use Instants;
with Robot_Motion;
with Robot_Truths;
with Svg_Files;         use Svg_Files;

package body Mission_Pictures is

   use type Micro;

   Pixel : constant := 1_000.0;
   --  Micrometres

   Edge : constant := 20.0;
   --  Pixels around the arena

   Width  : constant Float := Float (Robot_Motion.Arena_Width) / Pixel;
   Height : constant Float := Float (Robot_Motion.Arena_Height) / Pixel;

   After_The_End : constant Duration := 1.0;

   function Across (X : Micro) return Float is (Edge + Float (X) / Pixel);

   function Down (Y : Micro) return Float is
     (Edge + Height - Float (Y) / Pixel);

   procedure Draw
     (P     : Plan;
      Notes : Emulators.Notes;
      Path  : String;
      V     : out Verdict)
   is
      Drawing : Svg_File;
      J       : Judge;
      Begun   : constant Instant := Notes.First_Element.First;
      Shown   : Robot_Motion.Pose := P.Start;
      Ended   : Duration := 0.0;

      procedure See
        (Time : Instant; Where : Robot_Motion.Pose; Driving : Boolean);

      procedure See
        (Time : Instant; Where : Robot_Motion.Pose; Driving : Boolean)
      is
         Step : constant := 2_000;
         --  Micrometres between two points of the trail
      begin
         See_Pose (J, Time - Begun, Where, Driving);
         if abs (Where.X - Shown.X) + abs (Where.Y - Shown.Y) >= Step then
            Go_On (Drawing, Across (Where.X), Down (Where.Y));
            Shown := Where;
         end if;
         if Driving then
            Ended := Time - Begun;
         end if;
      end See;

   begin
      Create
        (Drawing, Path, "A mission: its planned path, and the robot's trail",
         Width + 2.0 * Edge, Height + 2.0 * Edge,
         ".page{fill:white}.wall{fill:none;stroke:#111;stroke-width:6}"
         & ".plan{fill:none;stroke:#f2c500;stroke-width:9;"
         & "stroke-linejoin:round}"
         & ".trail{fill:none;stroke:#0a3d91;stroke-width:2}"
         & ".point{fill:#c8102e}text{font:13px sans-serif;fill:#111}");
      Put_Box
        (Drawing, 0.0, 0.0, Width + 2.0 * Edge, Height + 2.0 * Edge, "page");
      Put_Box (Drawing, Edge - 3.0, Edge - 3.0, Width + 6.0, Height + 6.0,
               "wall");

      Begin_Curve (Drawing, "plan");
      Go_On (Drawing, Across (P.Start.X), Down (P.Start.Y));
      for K in 1 .. P.Count loop
         Go_On (Drawing, Across (P.Points (K).X), Down (P.Points (K).Y));
      end loop;
      End_Curve (Drawing);

      Start (J, P);
      Begin_Curve (Drawing, "trail");
      Go_On (Drawing, Across (P.Start.X), Down (P.Start.Y));
      Robot_Truths.Replay
        (Notes, P.Start, P.Wheels, Begun,
         Notes.Last_Element.Last + After_The_End, See'Access);
      End_Curve (Drawing);

      for K in 1 .. P.Count loop
         Put_Box
           (Drawing, Across (P.Points (K).X) - 4.0,
            Down (P.Points (K).Y) - 4.0, 8.0, 8.0, "point");
      end loop;
      Conclude (J, P, "done", Ended, Robot_Truths.Movements (Notes), V);
      Put_Text
        (Drawing, Edge + 8.0, Height + Edge - 10.0,
         "planned: yellow; points: red; where the robot truly was: blue");
      Close (Drawing);
   end Draw;

   procedure Read_Journal (Path : String; Notes : out Emulators.Notes) is
      File : File_Type;
   begin
      Notes.Clear;
      Open (File, In_File, Path);
      while not End_Of_File (File) loop
         declare
            Line : constant String := Get_Line (File);
         begin
            if Index (Line, "first=") = 1 then
               Notes.Append (Emulators.Note_Of (Line));
            end if;
         end;
      end loop;
      Close (File);
   end Read_Journal;

end Mission_Pictures;
