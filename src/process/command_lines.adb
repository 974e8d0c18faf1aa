--  SPDX-License-Identifier: GPL-3.0-or-later

with Missions;
with Networks;

package body Command_Lines with SPARK_Mode is

   procedure Fail
     (R : in out Reading; Before : String; Value : String; After : String)
   with
     Post => R.Request = Wrong;
   --  Reason: Before, Value in quotes, After

   procedure Fail (R : in out Reading; Message : String)
   with
     Post => R.Request = Wrong and then R.Chosen.Bind = R.Chosen.Bind'Old;

   procedure Take_Name (R : in out Reading; Name : String)
   with
     Pre  => R.Request not in Settled_Kind;
   --  "--name" or "-h"

   procedure Take_Value (R : in out Reading; Value : String)
   with
     Pre  => R.Request not in Settled_Kind
       and then R.Awaited /= None
       and then Value'First > 0
       and then Value'Last < Integer'Last,
     Post => R.Awaited = None;
   --  Reads the value of R.Awaited

   function Name_Of (Option : Option_Kind) return String is
     (case Option is
         when None        => "",
         when Port        => "--port",
         when Bind        => "--bind",
         when Allow       => "--allow",
         when Token       => "--token",
         when Silence     => "--monitor-silence",
         when Serial      => "--serial",
         when Answer_Timeout => "--answer-timeout",
         when Camera      => "--camera",
         when Frame_Size  => "--frame-size",
         when Frame_Rate  => "--fps",
         when Quality     => "--jpeg-quality",
         when Marker      => "--marker",
         when Drawing     => "--draw",
         when Arena_Size  => "--arena-size",
         when Message_Gap => "--message-gap",
         when Log_Level   => "--log-level",
         when Cpu         => "--cpu",
         when Trace       => "--trace",
         when First_Marker => "--print-markers",
         when Marker_Size  => "--marker-size");

   Max_Digits : constant := 9;

   procedure Fail (R : in out Reading; Message : String) is
   begin
      R.Request := Wrong;
      Texts.Set (R.Reason, Message);
   end Fail;

   procedure Fail
     (R : in out Reading; Before : String; Value : String; After : String)
   is
   begin
      Fail (R, Before);
      Texts.Append (R.Reason, "'");
      Texts.Append (R.Reason, Value);
      Texts.Append (R.Reason, "'");
      Texts.Append (R.Reason, After);
   end Fail;

   procedure Fail_Without_Value (R : in out Reading)
   with
     Post => R.Request = Wrong and then R.Chosen.Bind = R.Chosen.Bind'Old
   is
      --  The option's value is missing
   begin
      Fail (R, "a value is missing after ");
      Texts.Append (R.Reason, Name_Of (R.Awaited));
   end Fail_Without_Value;

   procedure Finish (R : in out Reading) is
   begin
      if R.Request not in Settled_Kind and then R.Awaited /= None then
         Fail_Without_Value (R);
      elsif R.Request in Run | Check | Stop
        and then R.Chosen.Marker_Size /= Options.Usual_Marker
      then
         Fail (R, "--marker-size: nothing to print without --print-markers");
      end if;
      if R.Chosen.Bind.Length = 0 then
         --  who may drive the robot over a network is said, not assumed
         Texts.Set
           (R.Chosen.Bind,
            (if Options.Is_Guarded (R.Chosen) then "0.0.0.0"
             else "127.0.0.1"));
      end if;
   end Finish;

   procedure Read_Network (R : in out Reading; Value : String) is
      --  Adds a network whose monitors are admitted
      Network : Networks.Network;
      Good    : Boolean;
   begin
      Networks.Parse (Value, Network, Good);
      if not Good then
         Fail (R, "--allow: ", Value,
               " is no IPv4 network, such as 192.168.1.0/24, with no bit set "
               & "after its length");
      elsif R.Chosen.Allowed.Count < Networks.Max_Networks then
         R.Chosen.Allowed.Count := R.Chosen.Allowed.Count + 1;
         R.Chosen.Allowed.Items (R.Chosen.Allowed.Count) := Network;
      else
         Fail (R, "--allow: more than ");
         Texts.Append (R.Reason, Networks.Max_Networks);
         Texts.Append (R.Reason, " networks");
      end if;
   end Read_Network;

   procedure Read_Number
     (R      : in out Reading;
      Value  : String;
      First  : Natural;
      Last   : Natural;
      Result : out Natural)
   with
     Pre  => First <= Last
       and then Value'Last < Integer'Last,
     Post => Result in First .. Last
   is
      --  The number Value, if in First .. Last; else First, and R is Wrong
      Number : Natural := 0;
      Good   : Boolean := Value'Length in 1 .. Max_Digits;
   begin
      if Good then
         for I in Value'Range loop
            pragma Loop_Invariant
              (Number < 10 ** (I - Value'First));
            if Value (I) in '0' .. '9' then
               Number := 10 * Number
                 + (Character'Pos (Value (I)) - Character'Pos ('0'));
            else
               Good := False;
               exit;
            end if;
         end loop;
      end if;
      if Good and then Number in First .. Last then
         Result := Number;
      else
         Result := First;
         Fail
           (R, Name_Of (R.Awaited) & ": ", Value, " is not a number in ");
         Texts.Append (R.Reason, First);
         Texts.Append (R.Reason, " .. ");
         Texts.Append (R.Reason, Last);
      end if;
   end Read_Number;

   procedure Read_Size
     (R             : in out Reading;
      Value         : String;
      First         : Natural;
      Last          : Natural;
      Width, Height : out Natural)
   with
     Pre  => First <= Last
       and then Value'First > 0
       and then Value'Last < Integer'Last,
     Post => Width in First .. Last and then Height in First .. Last
   is
      --  WIDTHxHEIGHT, each in First .. Last; else R is Wrong
      Cross : Natural := 0;
   begin
      Width := First;
      Height := First;
      for I in Value'Range loop
         if Value (I) = 'x' then
            Cross := I;
            exit;
         end if;
         pragma Loop_Invariant (Cross = 0);
      end loop;
      if Cross = 0 then
         Fail
           (R, Name_Of (R.Awaited) & ": ", Value, " is not WIDTHxHEIGHT");
         return;
      end if;
      Read_Number
        (R, Value (Value'First .. Cross - 1), First, Last, Width);
      if R.Request /= Wrong then
         Read_Number
           (R, Value (Cross + 1 .. Value'Last), First, Last, Height);
      end if;
   end Read_Size;

   procedure Read_Text
     (R : in out Reading; Value : String; Result : out Texts.Text)
   is
      --  Value; if it is empty, R is Wrong
   begin
      Texts.Set (Result, Value);
      if Value = "" then
         Fail_Without_Value (R);
      end if;
   end Read_Text;

   procedure Refuse_Long (R : in out Reading) is
   begin
      if R.Request not in Settled_Kind then
         Fail (R, "an argument has more than ");
         Texts.Append (R.Reason, Texts.Max_Length);
         Texts.Append (R.Reason, " characters");
      end if;
   end Refuse_Long;

   procedure Take (R : in out Reading; Argument : String) is
      Is_Name : constant Boolean :=
        Argument'Length > 2 and then Argument (1 .. 2) = "--";
   begin
      if R.Request in Settled_Kind then
         return;
      end if;

      if R.Awaited /= None then
         if Is_Name then
            Fail_Without_Value (R);
         else
            Take_Value (R, Argument);
         end if;
         return;
      end if;

      if not Is_Name and then Argument /= "-h" then
         Fail (R, "unexpected argument ", Argument, "");
         return;
      end if;

      for I in Argument'Range loop
         if Argument (I) = '=' then
            Take_Name (R, Argument (1 .. I - 1));
            if R.Request not in Settled_Kind then
               if R.Awaited = None then
                  Fail
                    (R, "option ", Argument (1 .. I - 1), " takes no value");
               else
                  Take_Value (R, Argument (I + 1 .. Argument'Last));
               end if;
            end if;
            return;
         end if;
      end loop;
      Take_Name (R, Argument);
   end Take;

   procedure Take_Name (R : in out Reading; Name : String) is
   begin
      if Name = "--help" or else Name = "-h" then
         R.Request := Show_Help;
      elsif Name = "--version" then
         R.Request := Show_Version;
      elsif Name = "--check" then
         R.Request := Check;
      elsif Name = "--stop" then
         R.Request := Stop;
      else
         R.Awaited := None;
         for Option in Port .. Option_Kind'Last loop
            if Name = Name_Of (Option) then
               R.Awaited := Option;
            end if;
         end loop;
         if R.Awaited = None then
            Fail (R, "unknown option ", Name, "");
         end if;
      end if;
   end Take_Name;

   procedure Take_Value (R : in out Reading; Value : String) is
      Number : Natural;
      Second : Natural;
      Text   : Texts.Text;
   begin
      case R.Awaited is
         when None =>
            null;
         when Port =>
            Read_Number
              (R, Value, Options.Port_Number'First, Options.Port_Number'Last,
               Number);
            R.Chosen.Port := Number;
         when Bind =>
            Read_Text (R, Value, Text);
            R.Chosen.Bind := Text;
         when Allow =>
            Read_Network (R, Value);
         when Token =>
            Read_Text (R, Value, Text);
            R.Chosen.Token_File := Text;
         when Silence =>
            Read_Number
              (R, Value, Options.Silence_Seconds'First,
               Options.Silence_Seconds'Last, Number);
            R.Chosen.Silence := Number;
         when Serial =>
            Read_Text (R, Value, Text);
            R.Chosen.Serial := Text;
         when Answer_Timeout =>
            Read_Number
              (R, Value, Options.Answer_Milliseconds'First,
               Options.Answer_Milliseconds'Last, Number);
            R.Chosen.Answer_Timeout := Number;
         when Camera =>
            Read_Text (R, Value, Text);
            R.Chosen.Camera := Text;
         when Frame_Size =>
            Read_Size
              (R, Value, Options.Pixel_Count'First, Options.Pixel_Count'Last,
               Number, Second);
            R.Chosen.Width := Number;
            R.Chosen.Height := Second;
         when Frame_Rate =>
            Read_Number
              (R, Value, Options.Rate'First, Options.Rate'Last,
               Number);
            R.Chosen.Frame_Rate := Number;
         when Quality =>
            Read_Number
              (R, Value, Options.Percentage'First, Options.Percentage'Last,
               Number);
            R.Chosen.Quality := Number;
         when Marker =>
            if Value = "aruco" then
               R.Chosen.Marker := Options.Aruco;
            elsif Value = "triangle" then
               R.Chosen.Marker := Options.Triangle;
            else
               Fail
                 (R, "--marker: ", Value, " is neither aruco nor triangle");
            end if;
         when Drawing =>
            if Value = "all" then
               R.Chosen.Drawing := Options.All_Of_It;
            elsif Value = "arena" then
               R.Chosen.Drawing := Options.Arena;
            elsif Value = "none" then
               R.Chosen.Drawing := Options.Nothing;
            else
               Fail (R, "--draw: ", Value, " is not all, arena or none");
            end if;
         when Arena_Size =>
            Read_Size
              (R, Value, Missions.Arena_Side'First, Missions.Arena_Side'Last,
               Number, Second);
            R.Chosen.Arena_Size := (Width => Number, Height => Second);
         when Message_Gap =>
            Read_Number
              (R, Value, Options.Milliseconds'First,
               Options.Milliseconds'Last, Number);
            R.Chosen.Message_Gap := Number;
         when Log_Level =>
            if Value = "error" then
               R.Chosen.Log_Level := Options.Error;
            elsif Value = "warning" then
               R.Chosen.Log_Level := Options.Warning;
            elsif Value = "info" then
               R.Chosen.Log_Level := Options.Info;
            elsif Value = "debug" then
               R.Chosen.Log_Level := Options.Debug;
            else
               Fail (R, "--log-level: ", Value, " is no level of the log");
            end if;
         when Cpu =>
            if Value = "auto" then
               R.Chosen.Cpu := Options.Last_Processor;
            else
               Read_Number
                 (R, Value, Options.Processor'First, Options.Processor'Last,
                  Number);
               R.Chosen.Cpu := Number;
            end if;
         when Trace =>
            Read_Text (R, Value, Text);
            R.Chosen.Trace_File := Text;
         when First_Marker =>
            Read_Number
              (R, Value, Options.Marker_Number'First,
               Options.Marker_Number'Last, Number);
            R.Chosen.First_Marker := Number;
            if R.Request /= Wrong then
               R.Request := Print_Markers;
            end if;
         when Marker_Size =>
            Read_Number
              (R, Value, Options.Marker_Millimetres'First,
               Options.Marker_Millimetres'Last, Number);
            R.Chosen.Marker_Size := Number;
      end case;
      R.Awaited := None;
   end Take_Value;

end Command_Lines;
