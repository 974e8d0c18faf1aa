--  SPDX-License-Identifier: GPL-3.0-or-later
--  A mission's picture.

with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Ada.Text_IO;       use Ada.Text_IO;

with Instants;          use Instants;
with Plain_Numbers;
with Robot_Motion;
with Robot_Truths;

package body Mission_Pictures is

   use type Micro;

   Pixel : constant := 1_000.0;
   --  Micrometres

   Edge : constant := 20.0;
   --  Pixels around the arena

   Width  : constant Float := Float (Robot_Motion.Arena_Width) / Pixel;
   Height : constant Float := Float (Robot_Motion.Arena_Height) / Pixel;

   After_The_End : constant Duration := 1.0;

   function Image (Value : Float) return String is
     (Plain_Numbers.Rounded (Value, 1));

   function Place (X, Y : Micro; Aside : Float := 0.0) return String is
     (Image (Edge + Float (X) / Pixel - Aside) & " "
      & Image (Edge + Height - Float (Y) / Pixel - Aside));

   procedure Draw
     (P     : Plan;
      Notes : Emulators.Notes;
      Path  : String;
      V     : out Verdict)
   is
      File  : File_Type;
      J     : Judge;
      Begun : constant Instant := Notes.First_Element.First;
      Shown : Robot_Motion.Pose := P.Start;
      Ended : Duration := 0.0;

      procedure See
        (Time : Instant; Where : Robot_Motion.Pose; Driving : Boolean)
      is
         Step : constant := 2_000;
         --  Micrometres between two points of the trail
      begin
         See_Pose (J, Time - Begun, Where, Driving);
         if abs (Where.X - Shown.X) + abs (Where.Y - Shown.Y) >= Step then
            Put_Line (File, Place (Where.X, Where.Y));
            Shown := Where;
         end if;
         if Driving then
            Ended := Time - Begun;
         end if;
      end See;

      Box : constant String :=
        Image (Width + 2.0 * Edge) & " " & Image (Height + 2.0 * Edge);
   begin
      Create (File, Out_File, Path);
      Put_Line
        (File,
         "<svg xmlns=""http://www.w3.org/2000/svg"" viewBox=""0 0 " & Box
         & """ style=""background:white"" role=""img"">");
      Put_Line (File, "<!-- SPDX-License-Identifier: GPL-3.0-or-later -->");
      Put_Line
        (File,
         "<title>A mission: its planned path, and the robot's trail</title>"
         & "<g fill=""none"">");
      Put_Line (File,
                "<path stroke=""#111"" stroke-width=""6"" d=""M"
                & Place (-3_000, Micro (Robot_Motion.Arena_Height) + 3_000)
                & "h" & Image (Width + 6.0) & "v" & Image (Height + 6.0)
                & "h" & Image (-Width - 6.0) & "z""/>");

      Put (File, "<path stroke=""#f2c500"" stroke-width=""9"""
           & " stroke-linejoin=""round"" d=""M");
      Put_Line (File, Place (P.Start.X, P.Start.Y));
      for K in 1 .. P.Count loop
         Put_Line (File, Place (P.Points (K).X, P.Points (K).Y));
      end loop;

      Start (J, P);
      Put (File, """/><path stroke=""#0a3d91"" stroke-width=""2"" d=""M");
      Put_Line (File, Place (P.Start.X, P.Start.Y));
      Robot_Truths.Replay
        (Notes, P.Start, P.Wheels, Begun,
         Notes.Last_Element.Last + After_The_End, See'Access);

      Put_Line (File, """/></g><path fill=""#c8102e"" d=""");
      for K in 1 .. P.Count loop
         Put_Line (File, "M" & Place (P.Points (K).X, P.Points (K).Y, 4.0)
                   & "h8v8h-8z");
      end loop;
      Conclude (J, P, "done", Ended, Robot_Truths.Movements (Notes), V);
      Put_Line
        (File,
         """/><text font-family=""sans-serif"" font-size=""13"" x="""
         & Image (Edge + 8.0) & """ y=""" & Image (Height + Edge - 10.0)
         & """>planned: yellow; points: red; where the robot truly was: blue"
         & "</text></svg>");
      Close (File);
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
