--  SPDX-License-Identifier: GPL-3.0-or-later
--  The messages received from the supervisor: shown, counted, summarised.

with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Base64_Texts;
with Bytes;
with Durations;
with Exchanges;             use Exchanges;
with GNAT.OS_Lib;
with Jpeg_Headers;
with Monitor.Notices;       use Monitor.Notices;
with Monitor.Protocol;      use Monitor.Protocol;
with Mutexes;
with Numerals;
with Position_Lines;
with Terminals;
with Words;

package body Accounts is

   Max_Image : constant := 4 * 2 ** 20;
   --  Bytes, as JPEG

   Pause : constant Duration := 1.0;
   --  Images with a longer interval are not one stream

   Settings_Start   : Time    := Time_First;
   Settings_Quiet   : Boolean := False;
   Settings_Each    : Boolean := False;
   Settings_Folder  : Unbounded_String;

   --  The latest image, in decoded form

   Guard        : Mutexes.Mutex;
   Image        : Bytes.Byte_Array (1 .. Max_Image);
   Image_Length : Natural := 0;
   Image_Number : Natural := 0;
   Image_At     : Time    := Time_First;
   Streaming    : Boolean := False;
   --  The latest image belongs to a stream, and is no answer

   --  Counters, written only by the task that receives the lines

   Latencies      : Durations.Set;
   Intervals      : Durations.Set;
   Image_Bytes    : Long_Long_Integer := 0;
   Positions      : Natural := 0;
   Without_Robot  : Natural := 0;
   Battery_Levels : Natural := 0;
   Surprises      : Natural := 0;

   --  The parts of the status line

   Battery_Words  : Unbounded_String := To_Unbounded_String ("-");
   Position_Words : Unbounded_String := To_Unbounded_String ("no position");
   Rate           : Long_Float := 0.0;
   --  Images a second, smoothed over the last few

   function Stamp (At_Time : Time) return String is
      --  Since the start of the connection, in seconds; nine characters
      Text : constant String :=
        Numerals.Seconds (To_Duration (At_Time - Settings_Start));
   begin
      return Tail (Text, Integer'Max (9, Text'Length));
   end Stamp;

   function Number_Words (Micros : Micro; Decimals : Positive) return String
   is (Numerals.Image (Long_Float (Micros) / 1.0E6, Decimals));

   procedure Write_Image (Name : String; OK : out Boolean) is
      --  Guard is held
      use GNAT.OS_Lib;
      File : constant File_Descriptor := Create_File (Name, Binary);
   begin
      OK := File /= Invalid_FD;
      if OK then
         OK := Write (File, Image'Address, Image_Length) = Image_Length;
         Close (File);
      end if;
      if not OK then
         Terminals.Put_Error ("cannot write " & Name);
      end if;
   end Write_Image;

   procedure Take_Battery (Line : String; Ended_At : Time);

   procedure Take_Image
     (Line : String; Given : Command; Asked : Boolean; Ended_At : Time);

   procedure Take_Mission (Line : String; Ended_At : Time);
   --  Its progress or its end

   procedure Take_Position (Line : String; Ended_At : Time);

   procedure Decode (Text : String; OK : out Boolean) is
      --  To Image
      Step   : constant := 512;
      --  Small pieces: the run-time cost of the decoder's contracts grows
      --  faster than the length
      Piece  : Bytes.Byte_Array (1 .. Step / 4 * 3);
      Length : Natural;
      First  : Positive := Text'First;
      Last   : Natural;
   begin
      Image_Length := 0;
      OK := Text'Length / 4 * 3 <= Max_Image;
      while OK and then First <= Text'Last loop
         Last := Integer'Min (First + Step - 1, Text'Last);
         Base64_Texts.Decode (Text (First .. Last), Piece, Length, OK);
         Image (Image_Length + 1 .. Image_Length + Length) :=
           Piece (1 .. Length);
         Image_Length := Image_Length + Length;
         --  Padding is allowed only at the end
         OK := OK and then (Length = Piece'Length or else Last = Text'Last);
         First := Last + 1;
      end loop;
   end Decode;

   function Image_Name return String is
      --  image_NNNN.jpg
      Digits_Text : constant String := Numerals.Image (Image_Number);
   begin
      return "image_"
        & (Integer'Max (0, 4 - Digits_Text'Length)) * '0'
        & Digits_Text & ".jpg";
   end Image_Name;

   function Level_Words (Line : String) return String is
     (if Line = "RBLV:0" then "empty"
      elsif Line = "RBLV:1" then "low"
      elsif Line = "RBLV:2" then "full"
      elsif Line = "RBLV:-1" then "unknown"
      else Line);
   --  Of a battery line

   function Meaning (Line : String) return String is
     (if Line = "AACK" then "done"
      elsif Line = "ANAK" then "not open, not found or failed"
      elsif Line = "ACRJ" then "refused"
      elsif Line = "ATIM" then "the robot does not answer"
      elsif Line = "ACER" then "not understood"
      elsif Line = "RCST:0" then "standing"
      elsif Line = "RCST:1" then "moving"
      elsif Head (Line, 4) = Battery_Label then
         "battery " & Level_Words (Line)
      else "?");
   --  Of an answer

   procedure Put (At_Time : Time; Mark : String; Text : String) is
      --  A line, unless --quiet
   begin
      if not Settings_Quiet then
         Terminals.Put_Line (Stamp (At_Time) & " " & Mark & " " & Text);
      end if;
   end Put;

   procedure Put_Answer (Line : String; Given : Command; Ended_At : Time) is
      Latency : constant Duration := To_Duration (Ended_At - Given.Sent_At);
   begin
      if not Given.Overdue then
         Durations.Add (Latencies, Latency);
      end if;
      Put
        (Ended_At, "<",
         Head (Line, Integer'Max (8, Line'Length))
         & Tail (Numerals.Milliseconds (Latency), 9) & " ms  "
         & Slice (Given.Text, 1, Integer'Min (Length (Given.Text), 32))
         & (if Head (Line, 4) = Image_Label then ""
            else ": " & Meaning (Line))
         & (if Given.Overdue then " (too late)" else ""));
   end Put_Answer;

   procedure Put_Sent (Line : String) is
   begin
      Put (Clock, ">", Line);
   end Put_Sent;

   procedure Put_Summary is

      function In_Milliseconds (Of_Set : Durations.Set) return String is
        ("median " & Numerals.Milliseconds (Durations.Quantile (Of_Set, 0.5))
         & " ms, p99 "
         & Numerals.Milliseconds (Durations.Quantile (Of_Set, 0.99))
         & " ms, max "
         & Numerals.Milliseconds (Durations.Quantile (Of_Set, 1.0)) & " ms");

      procedure Row (Name, Value : String) is
      begin
         Terminals.Put_Line (Head (Name, 11) & Value);
      end Row;

      Asked : constant Natural := Exchange.Answered + Exchange.Unanswered;
   begin
      Row
        ("connected",
         Numerals.Seconds (To_Duration (Clock - Settings_Start)) & " s");
      Row
        ("answers",
         Numerals.Image (Exchange.Answered) & " to "
         & Numerals.Image (Asked) & " commands"
         & (if Durations.Count (Latencies) = 0 then ""
            else "; latency " & In_Milliseconds (Latencies)));
      Row
        ("images",
         Numerals.Image (Image_Number)
         & (if Image_Number = 0 then ""
            else ", on average "
              & Numerals.Image
                  (Long_Float (Image_Bytes) / Long_Float (Image_Number)
                   / 1.0E3, 1)
              & " kB"));
      if Durations.Count (Intervals) > 0 then
         Row
           ("",
            Numerals.Image (1.0 / Long_Float (Durations.Mean (Intervals)), 3)
            & "/s; interval " & In_Milliseconds (Intervals));
      end if;
      if Image_Number > 0 and then Settings_Folder /= "" then
         Row ("", "saved in " & To_String (Settings_Folder));
      end if;
      Row
        ("positions",
         Numerals.Image (Positions)
         & (if Without_Robot = 0 then ""
            else ", " & Numerals.Image (Without_Robot)
              & " without a robot"));
      Row
        ("battery",
         Numerals.Image (Battery_Levels) & " levels"
         & (if Battery_Levels = 0 then ""
            else ", the last: " & To_String (Battery_Words)));
      if Surprises > 0 then
         Row ("", Numerals.Image (Surprises) & " unexpected lines");
      end if;
   end Put_Summary;

   procedure Put_Unanswered (Line : String; After : Duration) is
   begin
      Terminals.Put_Error
        ("no answer to " & Head (Line, Integer'Min (Line'Length, 32))
         & " within " & Numerals.Seconds (After) & " s");
   end Put_Unanswered;

   procedure Save_Latest (File : String; Saved : out Boolean) is
   begin
      Guard.Seize;
      Saved := Image_Number > 0 and then Image_Length > 0;
      if not Saved then
         Guard.Release;
         Terminals.Put_Error ("there is no image to save");
         return;
      end if;

      declare
         Name : constant String := (if File = "" then Image_Name else File);
      begin
         Write_Image (Name, Saved);
         Guard.Release;
         if Saved then
            Put (Clock, " ", "saved " & Name);
         end if;
      end;
   end Save_Latest;

   procedure Show_Status is
   begin
      Terminals.Set_Status
        ("battery " & To_String (Battery_Words)
         & " | image " & Numerals.Image (Image_Number)
         & ", " & Numerals.Image (Rate, 1) & "/s"
         & " | " & To_String (Position_Words));
   end Show_Status;

   procedure Start
     (Connected_At : Time;
      Quiet        : Boolean;
      Each_Message : Boolean;
      Folder       : String) is
   begin
      Settings_Start := Connected_At;
      Settings_Quiet := Quiet;
      Settings_Each := Each_Message;
      Settings_Folder := To_Unbounded_String (Folder);
   end Start;

   procedure Surprise (At_Time : Time; Text : String) is
   begin
      Surprises := Surprises + 1;
      Put (At_Time, "?", Text);
   end Surprise;

   procedure Take (Line : String; Begun_At : Time; Ended_At : Time) is
      Label  : constant String :=
        Line (1 .. Integer'Min (Line'Last, 4));
      Marked : constant Boolean := Line'Last >= 5 and then Line (5) = ':';
      --  There is data
      Asked  : Boolean;
      Given  : Command;
   begin
      Exchange.Match (Line, Begun_At, Asked, Given);

      if Label = Image_Label and then Marked then
         Take_Image (Line, Given, Asked, Ended_At);
      elsif Label = Battery_Label and then Marked then
         if Asked then
            Put_Answer (Line, Given, Ended_At);
         end if;
         Take_Battery (Line, Ended_At);
      elsif Asked then
         Put_Answer (Line, Given, Ended_At);
      elsif Label = Position_Label and then Marked then
         Take_Position (Line, Ended_At);
      elsif Label in Progress_Label | End_Label and then Marked then
         Take_Mission (Line, Ended_At);
      elsif Label = Log_Label and then Marked then
         Put (Ended_At, "*", Line (Line'First + 5 .. Line'Last));
      elsif Line = "ATIM" then
         Put (Ended_At, "*", "ATIM: the robot is lost");
      else
         Surprise
           (Ended_At,
            "unexpected: " & Head (Line, Integer'Min (Line'Length, 64)));
      end if;

      if Asked then
         Exchange.Published;
      end if;
   end Take;

   procedure Take_Battery (Line : String; Ended_At : Time) is
   begin
      Battery_Levels := Battery_Levels + 1;
      Battery_Words := To_Unbounded_String (Level_Words (Line));
      if Settings_Each then
         Put (Ended_At, "*", "battery " & To_String (Battery_Words));
      end if;
      Show_Status;
      Exchange.See (Words.Battery);
   end Take_Battery;

   procedure Take_Image
     (Line : String; Given : Command; Asked : Boolean; Ended_At : Time)
   is
      Interval : constant Duration :=
        (if Image_Number = 0 then 0.0
         else To_Duration (Ended_At - Image_At));
      Steady   : constant Boolean :=
        Streaming and then not Asked and then Interval in 1.0E-6 .. Pause;
      --  Interval is between two images of the same stream
      Width    : Natural;
      Height   : Natural;
      OK       : Boolean;
      Saved    : Boolean := True;
   begin
      Guard.Seize;
      Image_Number := Image_Number + 1;
      Image_At := Ended_At;
      Streaming := not Asked;
      Decode (Line (Line'First + 5 .. Line'Last), OK);
      Image_Bytes := Image_Bytes + Long_Long_Integer (Image_Length);
      Jpeg_Headers.Get_Size (Image (1 .. Image_Length), Width, Height);
      if OK and then Settings_Folder /= "" then
         Write_Image (To_String (Settings_Folder) & "/" & Image_Name, Saved);
      end if;
      Guard.Release;

      if Steady then
         Durations.Add (Intervals, Interval);
         Rate :=
           (if Rate = 0.0 then 1.0 / Long_Float (Interval)
            else 1.0 / (0.8 / Rate + 0.2 * Long_Float (Interval)));
      end if;

      if Asked then
         Put_Answer (Image_Label, Given, Ended_At);
      end if;
      if not OK or else Width = 0 then
         Surprise (Ended_At, "image " & Numerals.Image (Image_Number)
                   & ": no JPEG in base64");
      elsif Settings_Each or else Asked then
         Put
           (Ended_At, "*",
            "image " & Numerals.Image (Image_Number)
            & ": " & Numerals.Image (Image_Length) & " bytes, "
            & Numerals.Image (Width) & "x" & Numerals.Image (Height)
            & (if Image_Number = 1 then ""
               else ", " & Numerals.Milliseconds (Interval, 1)
                 & " ms after the previous"));
      end if;
      Show_Status;
      Exchange.See (Words.Image);
   end Take_Image;

   procedure Take_Mission (Line : String; Ended_At : Time) is
      Data   : constant String := Line (Line'First + 5 .. Line'Last);
      First  : constant Natural := Index (Data, ";");
      Second : constant Natural := Index (Data, ";", Ada.Strings.Backward);
   begin
      if Head (Line, 4) = End_Label then
         Put (Ended_At, "*", "mission " & Data);
         Exchange.See_End (Data);
      elsif First < Second then
         Put
           (Ended_At, "*",
            "mission: leg " & Data (Data'First .. First - 1) & " of "
            & Data (First + 1 .. Second - 1) & ", "
            & Data (Second + 1 .. Data'Last) & " mm to go");
      else
         Surprise (Ended_At, "no progress: " & Data);
      end if;
   end Take_Mission;

   procedure Take_Position (Line : String; Ended_At : Time) is
      P  : Position;
      OK : Boolean;
   begin
      Position_Lines.Parse (Line, P, OK);
      if not OK then
         Surprise
           (Ended_At,
            "position: "
            & Head (Line, Integer'Min (Line'Last, Max_Short_Line)));
         return;
      end if;

      Positions := Positions + 1;
      if P.Id = -1 then
         Without_Robot := Without_Robot + 1;
         Position_Words := To_Unbounded_String ("no robot");
      else
         Position_Words := To_Unbounded_String
           ("robot " & Numerals.Image (P.Id)
            & ", angle " & Number_Words (P.Angle, 2)
            & ", centre (" & Number_Words (P.Cx, 1)
            & ", " & Number_Words (P.Cy, 1) & ")");
      end if;

      if Settings_Each then
         Put (Ended_At, "*", "position: " & To_String (Position_Words));
      end if;
      Show_Status;
      Exchange.See (Words.Position);
      if P.Id /= -1 then
         Exchange.See (Words.Robot);
      end if;
   end Take_Position;

   procedure Take_Too_Long (Ended_At : Time) is
   begin
      Surprise (Ended_At, "a line too long to be read");
   end Take_Too_Long;

end Accounts;
