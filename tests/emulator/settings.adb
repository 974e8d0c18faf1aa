--  SPDX-License-Identifier: GPL-3.0-or-later
--  What can be chosen on the emulator's command line.

with Ada.Command_Line;   use Ada.Command_Line;
with Ada.Exceptions;
with Ada.Strings.Fixed;  use Ada.Strings.Fixed;

with Answer_Faults;
with Readings;           use Readings;

package body Settings is

   procedure Set (V : in out Values; Name, Text : String);
   --  An option that takes a value; Bad_Value where either is wrong

   function Takes_Value (Name : String) return Boolean is
     (Name not in "--silent" | "--charging" | "--help" | "--version");

   -----------------------
   -- Read_Command_Line --
   -----------------------

   procedure Read_Command_Line
     (V : out Values; W : out Wish; Reason : out Unbounded_String)
   is
      Next : Positive := 1;
   begin
      V := (others => <>);
      W := Work;
      Reason := Null_Unbounded_String;

      while Next <= Argument_Count loop
         declare
            Given : constant String  := Argument (Next);
            Sign  : constant Natural := Index (Given, "=");
            Name  : constant String  :=
              (if Sign > 0 then Given (Given'First .. Sign - 1) else Given);
         begin
            if not Takes_Value (Name) then
               if Sign > 0 then
                  raise Bad_Value with "takes no value";
               elsif Name = "--silent" then
                  V.Silent := True;
               elsif Name = "--charging" then
                  V.Charging := True;
               elsif Name = "--help" then
                  W := Show_Help;
               else
                  W := Show_Version;
               end if;
            elsif Sign > 0 then
               Set (V, Name, Given (Sign + 1 .. Given'Last));
            elsif Next < Argument_Count then
               Next := Next + 1;
               Set (V, Name, Argument (Next));
            else
               Set (V, Name, "");
            end if;
         exception
            when Problem : Bad_Value =>
               W := Bad_Usage;
               Reason := To_Unbounded_String
                 (Name & ": " & Ada.Exceptions.Exception_Message (Problem));
               return;
         end;
         Next := Next + 1;
      end loop;
   end Read_Command_Line;

   ---------
   -- Set --
   ---------

   procedure Set (V : in out Values; Name, Text : String) is
      subtype Remaining is Answer_Faults.Remaining;
   begin
      if Name = "--link" then
         if Text = "" then
            raise Bad_Value with "a path is expected";
         end if;
         V.Link := To_Unbounded_String (Text);

      elsif Name = "--baud" then
         V.Baud := Whole
           (Text, Serial_Side.Baud_Rate'First, Serial_Side.Baud_Rate'Last);

      elsif Name = "--boot-ms" then
         V.Boot := Natural'Max (1, (Whole (Text, 0, 600_000) + 99) / 100);

      elsif Name = "--battery" then
         V.Battery := Battery (Text);

      elsif Name = "--pose" then
         declare
            First  : constant Natural := Index (Text, ",");
            Second : constant Natural :=
              (if First > 0 then Index (Text, ",", First + 1) else 0);
         begin
            if Second = 0 then
               raise Bad_Value with "X,Y,HEADING is expected";
            end if;
            V.Pose := Pose
              (Text (Text'First .. First - 1), Text (First + 1 .. Second - 1),
               Text (Second + 1 .. Text'Last));
         end;

      elsif Name = "--camera-port" then
         V.Camera_Port := Whole (Text, 0, 65_535);
         V.With_Camera := True;

      elsif Name = "--camera-fps" then
         V.Camera.Rate := Whole
           (Text, Arena_Camera.Frame_Rate'First,
            Arena_Camera.Frame_Rate'Last);

      elsif Name = "--frame-size" then
         Size (Text, V.Camera.Width, V.Camera.Height);

      elsif Name = "--noise" then
         V.Camera.Noise := Whole
           (Text, Arena_Camera.Noise_Level'First,
            Arena_Camera.Noise_Level'Last);

      elsif Name = "--marker" then
         if Text = "aruco" then
            V.Camera.Marker := Arena_Camera.Aruco;
         elsif Text = "triangle" then
            V.Camera.Marker := Arena_Camera.Triangle;
         else
            raise Bad_Value with "aruco or triangle is expected";
         end if;

      elsif Name = "--marker-id" then
         V.Camera.Marker_Id := Whole
           (Text, Arena_Camera.Marker_Number'First,
            Arena_Camera.Marker_Number'Last);

      elsif Name = "--drop" then
         V.Drop := Whole (Text, Remaining'First, Remaining'Last);
      elsif Name = "--corrupt" then
         V.Corrupt := Whole (Text, Remaining'First, Remaining'Last);
      elsif Name = "--garbage" then
         V.Garbage := Whole (Text, Remaining'First, Remaining'Last);
      elsif Name = "--truncate" then
         V.Truncate := Whole (Text, Remaining'First, Remaining'Last);
      elsif Name = "--delay" then
         V.Late := Whole (Text, 0, Largest_Delay);

      else
         raise Bad_Value with "unknown option";
      end if;
   end Set;

end Settings;
