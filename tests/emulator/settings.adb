--  SPDX-License-Identifier: GPL-3.0-or-later
--  What can be chosen on the emulator's command line.

with Ada.Exceptions;
with Ada.Strings.Fixed;  use Ada.Strings.Fixed;

with Option_Readers;     use Option_Readers;
with Readings;           use Readings;

package body Settings is

   procedure Set (V : in out Values);
   --  The option that Option_Readers is at, which takes a value

   procedure Set_Pose (V : in out Values; Text : String) is
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
   end Set_Pose;

   procedure Set_Marker (V : in out Values; Text : String) is
   begin
      if Text = "aruco" then
         V.Camera.Marker := Arena_Camera.Aruco;
      elsif Text = "triangle" then
         V.Camera.Marker := Arena_Camera.Triangle;
      else
         raise Bad_Value with "aruco or triangle is expected";
      end if;
   end Set_Marker;

   procedure Read_Command_Line
     (V : out Values; W : out Wish; Reason : out Unbounded_String) is
   begin
      V := (others => <>);
      W := Work;
      Reason := Null_Unbounded_String;

      while Next loop
         if Name = "--silent" then
            V.Silent := True;
         elsif Name = "--stay-on" then
            V.Stay_On := True;
         elsif Name = "--charging" then
            V.Charging := True;
         elsif Name = "--radio" then
            V.Radio := True;
         elsif Name = "--help" then
            W := Show_Help;
         elsif Name = "--version" then
            W := Show_Version;
         else
            V.Radio := V.Radio or else Index (Name, "--radio") = 1;
            Set (V);
         end if;
      end loop;
   exception
      when Problem : Bad_Value =>
         W := Bad_Usage;
         Reason := To_Unbounded_String
           (Name & ": " & Ada.Exceptions.Exception_Message (Problem));
      when Problem : Option_Readers.Bad_Usage =>
         W := Bad_Usage;
         Reason := To_Unbounded_String
           (Ada.Exceptions.Exception_Message (Problem));
   end Read_Command_Line;

   procedure Set (V : in out Values) is
   begin
      for Kind in Robot_Bench.Fault_Option loop
         if Is_Word_Of (Name (3 .. Name'Last), Kind) then
            V.Faults (Kind) := Fault_Value (Kind, Value);
            return;
         end if;
      end loop;
      if Name = "--link" or else Name = "--socket" then
         V.Socket := Name = "--socket";
         V.Link := To_Unbounded_String (Value);
         if V.Link = "" then
            raise Bad_Value with "a path is expected";
         end if;
      elsif Name = "--baud" then
         V.Baud := Number
           (Serial_Side.Baud_Rate'First, Serial_Side.Baud_Rate'Last);
      elsif Name = "--boot-ms" then
         V.Boot := Natural'Max (1, (Number (0, 600_000) + 99) / 100);
      elsif Name = "--battery" then
         V.Battery := Battery (Value);
      elsif Name = "--pose" then
         Set_Pose (V, Value);
      elsif Name = "--speed" then
         V.Wheels.Speed := Number (Robot_Motion.Speed_Percent'First,
                                   Robot_Motion.Speed_Percent'Last);
      elsif Name = "--turn-speed" then
         V.Wheels.Turn_Speed := Number (Robot_Motion.Speed_Percent'First,
                                        Robot_Motion.Speed_Percent'Last);
      elsif Name = "--overshoot" then
         V.Wheels.Overshoot := Number (Robot_Motion.Overshoot_Percent'First,
                                       Robot_Motion.Overshoot_Percent'Last);
      elsif Name = "--radio-seed" then
         V.Seed := Number (0);
      elsif Name = "--pull" then
         V.Wheels.Pull := Number
           (Robot_Motion.Pull_Angle'First, Robot_Motion.Pull_Angle'Last);
      elsif Name = "--camera-port" then
         V.Camera_Port := Number (0, 65_535);
         V.With_Camera := True;
      elsif Name = "--camera-fps" then
         V.Camera.Rate := Number
           (Arena_Camera.Frame_Rate'First, Arena_Camera.Frame_Rate'Last);
      elsif Name = "--frame-size" then
         Size (Value, V.Camera.Width, V.Camera.Height);
      elsif Name = "--noise" then
         V.Camera.Noise := Number
           (Arena_Camera.Noise_Level'First, Arena_Camera.Noise_Level'Last);
      elsif Name = "--camera-delay" then
         V.Camera.Late := Number
           (Arena_Camera.Delay_Time'First, Arena_Camera.Delay_Time'Last);
      elsif Name = "--position-noise" then
         V.Camera.Displaced := Number (Arena_Camera.Displacement'First,
                                       Arena_Camera.Displacement'Last);
      elsif Name = "--marker" then
         Set_Marker (V, Value);
      elsif Name = "--marker-id" then
         V.Camera.Marker_Id := Number (Arena_Camera.Marker_Number'First,
                                       Arena_Camera.Marker_Number'Last);
      elsif Name = "--delay" then
         V.Late := Number (0, Largest_Delay);
      else
         Refuse;
      end if;
   end Set;

end Settings;
