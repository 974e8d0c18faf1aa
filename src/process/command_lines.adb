--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Decimals;
with Missions;
with Networks;
with Process;

package body Command_Lines with SPARK_Mode is

   package Numbers is new Decimals (Character, String);

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

   procedure Fail (R : in out Reading; Reason : String)
   with Post => R.Request = Wrong and then R.Chosen.Bind = R.Chosen.Bind'Old
   is
   begin
      R.Request := Wrong;
      Texts.Set (R.Reason, Reason);
   end Fail;

   procedure Fail_Without_Value (R : in out Reading)
   with Post => R.Request = Wrong and then R.Chosen.Bind = R.Chosen.Bind'Old
   is
   begin
      Fail (R, "a value is missing after ");
      Texts.Append (R.Reason, Name_Of (R.Awaited));
   end Fail_Without_Value;

   procedure Take_Name (R : in out Reading; Name : String)
   with
     Pre  => R.Request not in Settled_Kind
       and then Name'Length <= Texts.Max_Length
   is
      --  "--name" or "-h"
   begin
      R.Awaited := None;
      if Name = "--help" or else Name = "-h" then
         R.Request := Show_Help;
      elsif Name = "--version" then
         R.Request := Show_Version;
      elsif Name = "--check" then
         R.Request := Check;
      elsif Name = "--stop" then
         R.Request := Stop;
      else
         for Option in Port .. Option_Kind'Last loop
            if Name = Name_Of (Option) then
               R.Awaited := Option;
            end if;
         end loop;
         if R.Awaited = None then
            Fail (R, "unknown option '" & Name & "'");
         end if;
      end if;
   end Take_Name;

   procedure Take_Value (R : in out Reading; Value : String)
   with
     Pre  => R.Request not in Settled_Kind
       and then R.Awaited /= None
       and then Value'Length <= Texts.Max_Length
       and then Value'First > 0
       and then Value'Last < Integer'Last,
     Post => R.Awaited = None
   is
      --  Reads the value of R.Awaited
      Name : constant String := Name_Of (R.Awaited);
      Why  : Texts.Text;
      --  it cannot be taken

      procedure Refuse (Part, Text : String)
      with Pre => Part'Length <= Texts.Max_Length and then Text'Length <= 100
      is
      begin
         Texts.Set (Why, Name);
         Texts.Append (Why, ": '");
         Texts.Append (Why, Part);
         Texts.Append (Why, "'");
         Texts.Append (Why, Text);
      end Refuse;

      procedure Read
        (Number : in out Natural;
         First  : Natural;
         Last   : Natural;
         Part   : String := Value)
      with
        Pre  => Part'Length = 0
          or else (Part'First > 0
                   and then Part'Length <= Texts.Max_Length),
        Post => Number in First .. Last or else Number = Number'Old
      is
         --  The number Part, in First .. Last
         Found : constant Integer :=
           (if Part'Length > 0
              and then Numbers.Are_Digits (Part, Part'First, Part'Last)
            then Numbers.Saturated_Value (Part, Part'First, Part'Last)
            else -1);
      begin
         if Found in First .. Last then
            Number := Found;
         else
            Refuse (Part, " is not a number in ");
            Texts.Append (Why, First);
            Texts.Append (Why, " .. ");
            Texts.Append (Why, Last);
         end if;
      end Read;

      procedure Read_Size
        (Width, Height : in out Natural; First, Last : Natural)
      is
         --  WIDTHxHEIGHT, each in First .. Last
         Cross : constant Natural := Index (Value, "x");
      begin
         if Cross = 0 then
            Refuse (Value, " is not WIDTHxHEIGHT");
         else
            Read (Width, First, Last, Value (Value'First .. Cross - 1));
            if Why.Length = 0 then
               Read (Height, First, Last, Value (Cross + 1 .. Value'Last));
            end if;
         end if;
      end Read_Size;

      procedure Read (Text : out Texts.Text) is
         --  Any that is not empty
      begin
         Texts.Set (Text, Value);
         if Value = "" then
            Texts.Set (Why, "a value is missing after " & Name);
         end if;
      end Read;

      procedure Read (List : in out Networks.List) is
         --  One more network
         Network : Networks.Network;
         Good    : Boolean;
      begin
         Networks.Parse (Value, Network, Good);
         if not Good then
            Refuse
              (Value,
               " is no IPv4 network, such as 192.168.1.0/24, with no bit set "
               & "after its length");
         elsif List.Count < Networks.Max_Networks then
            List.Count := List.Count + 1;
            List.Items (List.Count) := Network;
         else
            Texts.Set (Why, "--allow: more than ");
            Texts.Append (Why, Networks.Max_Networks);
            Texts.Append (Why, " networks");
         end if;
      end Read;

      use Options;
      Chosen : Values renames R.Chosen;

   begin
      case R.Awaited is
         when None =>
            null;
         when Port =>
            Read (Chosen.Port, Port_Number'First, Port_Number'Last);
         when Bind =>
            Read (Chosen.Bind);
         when Allow =>
            Read (Chosen.Allowed);
         when Token =>
            Read (Chosen.Token_File);
         when Silence =>
            Read (Chosen.Silence, Silence_Seconds'First, Silence_Seconds'Last);
         when Serial =>
            Read (Chosen.Serial);
         when Answer_Timeout =>
            Read (Chosen.Answer_Timeout, Answer_Milliseconds'First,
                  Answer_Milliseconds'Last);
         when Camera =>
            Read (Chosen.Camera);
         when Frame_Size =>
            Read_Size
              (Chosen.Width, Chosen.Height, Pixel_Count'First,
               Pixel_Count'Last);
         when Frame_Rate =>
            Read (Chosen.Frame_Rate, Rate'First, Rate'Last);
         when Quality =>
            Read (Chosen.Quality, Percentage'First, Percentage'Last);
         when Marker =>
            if Value = "aruco" then
               Chosen.Marker := Aruco;
            elsif Value = "triangle" then
               Chosen.Marker := Triangle;
            else
               Refuse (Value, " is neither aruco nor triangle");
            end if;
         when Drawing =>
            if Value = "all" then
               Chosen.Drawing := All_Of_It;
            elsif Value = "arena" then
               Chosen.Drawing := Arena;
            elsif Value = "none" then
               Chosen.Drawing := Nothing;
            else
               Refuse (Value, " is not all, arena or none");
            end if;
         when Arena_Size =>
            Read_Size
              (Chosen.Arena_Size.Width, Chosen.Arena_Size.Height,
               Missions.Arena_Side'First, Missions.Arena_Side'Last);
         when Message_Gap =>
            Read (Chosen.Message_Gap, Milliseconds'First, Milliseconds'Last);
         when Log_Level =>
            Refuse (Value, " is no level of the log");
            for Item in Level loop
               if Value = Name_Of (Item) then
                  Chosen.Log_Level := Item;
                  Why.Length := 0;
               end if;
            end loop;
         when Cpu =>
            if Value = "auto" then
               Chosen.Cpu := Last_Processor;
            else
               Chosen.Cpu := 0;
               Read (Chosen.Cpu, Processor'First, Processor'Last);
            end if;
         when Trace =>
            Read (Chosen.Trace_File);
         when First_Marker =>
            Read
              (Chosen.First_Marker, Marker_Number'First, Marker_Number'Last);
            R.Request := Print_Markers;
         when Marker_Size =>
            Read (Chosen.Marker_Size, Marker_Millimetres'First,
                  Marker_Millimetres'Last);
      end case;
      R.Awaited := None;
      if Why.Length > 0 then
         R.Request := Wrong;
         R.Reason := Why;
      end if;
   end Take_Value;

   procedure Take (R : in out Reading; Argument : String) is
      Is_Name : constant Boolean :=
        Argument'Length > 2 and then Argument (1 .. 2) = "--";
      Equals  : constant Natural := Index (Argument, "=");
      Last    : constant Natural :=
        (if Equals > 0 then Equals - 1 else Argument'Length);
      --  of the option's name
   begin
      if R.Request in Settled_Kind then
         null;
      elsif Argument'Length > Texts.Max_Length then
         Fail (R, "an argument has more than ");
         Texts.Append (R.Reason, Texts.Max_Length);
         Texts.Append (R.Reason, " characters");
      elsif R.Awaited /= None and then Is_Name then
         Fail_Without_Value (R);
      elsif R.Awaited /= None then
         Take_Value (R, Argument);
      elsif not Is_Name and then Argument /= "-h" then
         Fail (R, "unexpected argument '" & Argument & "'");
      else
         Take_Name (R, Argument (1 .. Last));
         if R.Request in Settled_Kind or else Equals = 0 then
            null;
         elsif R.Awaited = None then
            Fail (R, "option '" & Argument (1 .. Last) & "' takes no value");
         else
            Take_Value (R, Argument (Equals + 1 .. Argument'Last));
         end if;
      end if;
   end Take;

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

begin
   for I in 1 .. Process.Argument_Count loop
      Take (Given, Process.Argument (I));
   end loop;
   Finish (Given);
end Command_Lines;
