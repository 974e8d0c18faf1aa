--  SPDX-License-Identifier: GPL-3.0-or-later
--  The commands on standard input.

with Ada.Exceptions;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Maps;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Interfaces.C;          use Interfaces.C;

with Answer_Faults;
with Arena_Camera;
with Instants;              use Instants;
with Journals;
with Libc;
with Polls;
with Readings;              use Readings;
with Robot_Bench;           use Robot_Bench;
with Robot_Core;
with Robot_Motion;
with Serial_Side;
with Settings;
with Stop_Signals;

package body Bench_Console is

   Standard_Input  : constant := 0;
   Standard_Output : constant := 1;

   An_Hour : constant Duration := 3_600.0;

   Blanks : constant Ada.Strings.Maps.Character_Set :=
     Ada.Strings.Maps.To_Set (' ' & ASCII.HT & ASCII.CR);

   task Reader is
      entry Start;
   end Reader;

   procedure Obey_Camera (Name, Rest : String) is
      --  A command to the camera that takes a value
      use Arena_Camera;
      S : Arena_Camera.Settings := Configuration;
   begin
      if Name = "size" then
         Size (Rest, S.Width, S.Height);
      elsif Name = "fps" then
         S.Rate := Whole (Rest, Frame_Rate'First, Frame_Rate'Last);
      elsif Name = "opening" then
         S.Opening := Whole (Rest, 0, Opening_Time'Last);
      elsif Name = "delay" then
         S.Late := Whole (Rest, Delay_Time'First, Delay_Time'Last);
      elsif Name = "position-noise" then
         S.Displaced := Whole (Rest, Displacement'First, Displacement'Last);
      else
         raise Bad_Value with
           "on, off, stall, garbage, size, fps, opening, delay,"
           & " position-noise or mend is expected";
      end if;
      Configure (S);
   end Obey_Camera;

   procedure Print_Journal is
      Note   : Journals.Note;
      Number : Journals.Note_Number := 0;
      Found  : Journals.Note_Number;
   begin
      loop
         Bench.Next_Note (Number, Note, Found);
         exit when Found = 0;
         Say (Journals.Image (Note));
         Number := Found;
      end loop;
   end Print_Journal;

   procedure Print_Help is
   begin
      Say ("silent on|off        no answer at all");
      Say ("lose N               the next N commands do not arrive");
      Say ("lose-every N         every Nth does not; 0: all do");
      Say ("drop N               the next N answers are lost");
      Say ("drop-every N         every Nth is lost; 0: none");
      Say ("corrupt N            ... have a wrong checksum");
      Say ("garbage N            ... are random bytes instead");
      Say ("truncate N [KEEP]    ... lack their carriage return, or are");
      Say ("                     cut after KEEP bytes");
      Say ("flip N [BIT]         ... have one bit flipped: the first that");
      Say ("                     one, each its next");
      Say ("wrong N              ... answer another question");
      Say ("pile N               ... are held, and come with the last");
      Say ("endless on|off       the next answer does not end");
      Say ("delay MS             every answer is late");
      Say ("radio-losses N       N percent of the packets are lost, each");
      Say ("                     direction (--radio)");
      Say ("radio-bursts N       N percent begin a burst of retries");
      Say ("mend                 none of these any more");
      Say ("radio-retries N      percent of attempts repeated (--radio)");
      Say ("unasked BYTES        sends them now; \r, \n, \\, \xHH");
      Say ("hangup               the device goes away");
      Say ("return               and comes back, as a new one");
      Say ("device               its path");
      Say ("battery LEVEL        0, 1, 2, or critical: silent, off in 4 s; or "
           & "its volts");
      Say ("charge on|off        the charger's plug");
      Say ("pose X Y HEADING     puts the robot there: cm, degrees");
      Say ("speed N              percent straight on, 3 to 200; this and");
      Say ("                     the next three from the next order on");
      Say ("turn-speed N         percent of turns, 3 to 200");
      Say ("overshoot N          turns go on by N percent, 0 to 20");
      Say ("pull N               degrees to the left per metre, -30 to 30");
      Say ("reset-robot          switches it off and on");
      Say ("starve               its watchdog, if on, disables it");
      Say ("camera on|off|stall  off: closed; stall: no image comes");
      Say ("camera garbage       what comes is no image");
      Say ("camera size WxH      1x1 to 4096x2304, from the next image on");
      Say ("camera fps N         1 to 240");
      Say ("camera opening MS    it takes so long to open");
      Say ("camera delay MS      images show the robot so long ago");
      Say ("camera position-noise PX");
      Say ("                     each displaces the robot, 0 to 10");
      Say ("camera mend          on, and all of these as at first");
      Say ("status               one line");
      Say ("journal              every command since it was cleared");
      Say ("journal clear");
      Say ("quit                 as SIGTERM does");
   end Print_Help;

   function Status return String is
      use type Robot_Core.State_Kind;

      R : Robot_Core.Robot;
      P : Robot_Motion.Pose;

      function Plain (Value : Natural) return String is
        (Trim (Value'Image, Ada.Strings.Left));

      function Switch (Value : Boolean) return String is
        (if Value then "on" else "off");
   begin
      Look (R, Now);
      P := Robot_Core.Pose (R);
      return "state=" & Journals.Image (Robot_Core.State (R))
        & " x=" & Image (P.X, 10_000)
        & " y=" & Image (P.Y, 10_000)
        & " heading=" & Image (P.Angle, 1_000_000)
        & " moving="
        & (if Robot_Core.State (R) = Robot_Core.Movement then "1" else "0")
        & " watchdog=" & Switch (Robot_Core.Watchdog_On (R))
        & " missed=" & Plain (Robot_Core.Missed (R))
        & " missed_total=" & Plain (Robot_Core.Missed_Total (R))
        & " disabled_count=" & Plain (Robot_Core.Disabled_Count (R))
        & " battery="
        & (case Robot_Core.Battery (R) is
              when Robot_Core.Critical => "critical",
              when Robot_Core.Empty    => "0",
              when Robot_Core.Low      => "1",
              when Robot_Core.Full     => "2")
        & " commands=" & Plain (Robot_Core.Commands (R))
        & " stops=" & Plain (Robot_Core.Stops (R))
        & " spoilt=" & Plain (Bench.Spoilt)
        & " charging=" & Switch (Robot_Core.Charging (R))
        & " device=" & Serial_Side.Device
        & " viewers=" & Plain (Arena_Camera.Viewers)
        & " frames=" & Plain (Arena_Camera.Frames);
   end Status;

   procedure Must_Be (Outcome : String) is
      --  Bad_Value unless it is ""
   begin
      if Outcome /= "" then
         raise Bad_Value with Outcome;
      end if;
   end Must_Be;

   procedure No_More (Rest : String) is
      --  Bad_Value unless it is ""
   begin
      if Rest /= "" then
         raise Bad_Value with "takes no value";
      end if;
   end No_More;

   procedure Obey (Name, Rest : String; Answer : in out Unbounded_String) is
      --  The same; Bad_Value says what is wrong. Answer: if not "ok".
      Stop : constant Natural := Index (Rest & " ", Blanks);

      function Second (Highest, Default : Natural) return Natural is
        (if Stop > Rest'Last then Default
         else Whole (Trim (Rest (Stop .. Rest'Last), Blanks, Blanks),
                     0, Highest));

      Wheels : Robot_Motion.Wheel_Errors := Bench.Wheels;

      function Is_Fault return Boolean is
         --  Then it is set
      begin
         for Kind in Fault_Command loop
            if Is_Word_Of (Name, Kind) then
               if Kind = Truncate then
                  Bench.Set
                    (Kept_Bytes, Second (Robot_Core.Answer_Length'Last, 0));
               elsif Kind = Flip and then Stop < Rest'Last then
                  Bench.Set (Bit, Second (Answer_Faults.Bit_Number'Last, 0));
               end if;
               Bench.Set (Kind,
                          Fault_Value
                            (Kind,
                             (if Kind in Truncate | Flip
                              then Rest (Rest'First .. Stop - 1) else Rest)));
               return True;
            end if;
         end loop;
         return False;
      end Is_Fault;

      procedure Say_Device is
      begin
         Answer := To_Unbounded_String ("ok device " & Serial_Side.Device);
      end Say_Device;

   begin
      if Is_Fault then
         null;
      elsif Name = "mend" then
         No_More (Rest);
         Bench.Mend;
      elsif Name = "delay" then
         Bench.Set_Delay (Instant (Whole (Rest, 0, Settings.Largest_Delay))
                          * 1_000_000);

      elsif Name = "unasked" then
         if Rest = "" then
            raise Bad_Value with "bytes are expected";
         end if;
         Must_Be (Serial_Side.Send_Unasked (Bytes (Rest)));
      elsif Name = "hangup" then
         No_More (Rest);
         Must_Be (Serial_Side.Hang_Up);
      elsif Name = "return" then
         No_More (Rest);
         Must_Be (Serial_Side.Put_Back);
         Say_Device;
      elsif Name = "device" then
         No_More (Rest);
         Say_Device;

      elsif Name = "battery" then
         Bench.Set_Battery (Battery (Rest));
      elsif Name = "charge" then
         Bench.Set_Charging (On_Or_Off (Rest));
      elsif Name = "reset-robot" then
         No_More (Rest);
         Bench.Switch_On;
      elsif Name = "starve" then
         No_More (Rest);
         Bench.Starve;
      elsif Name = "pose" then
         declare
            First  : constant Natural := Index (Rest, " ");
            Second : constant Natural :=
              (if First > 0 then Index (Rest, " ", Rest'Last,
                                        Ada.Strings.Backward) else 0);
         begin
            if Second <= First then
               raise Bad_Value with "X Y HEADING are expected";
            end if;
            Bench.Place
              (Pose (Rest (Rest'First .. First - 1),
                     Trim (Rest (First + 1 .. Second - 1), Blanks, Blanks),
                     Rest (Second + 1 .. Rest'Last)));
         end;

      elsif Name = "speed" then
         Wheels.Speed := Whole (Rest, Robot_Motion.Speed_Percent'First,
                                Robot_Motion.Speed_Percent'Last);
         Bench.Set_Wheels (Wheels);
      elsif Name = "turn-speed" then
         Wheels.Turn_Speed := Whole (Rest, Robot_Motion.Speed_Percent'First,
                                     Robot_Motion.Speed_Percent'Last);
         Bench.Set_Wheels (Wheels);
      elsif Name = "overshoot" then
         Wheels.Overshoot := Whole (Rest, Robot_Motion.Overshoot_Percent'First,
                                    Robot_Motion.Overshoot_Percent'Last);
         Bench.Set_Wheels (Wheels);
      elsif Name = "pull" then
         Wheels.Pull := Whole (Rest, Robot_Motion.Pull_Angle'First,
                               Robot_Motion.Pull_Angle'Last);
         Bench.Set_Wheels (Wheels);

      elsif Name = "camera" then
         if Rest = "stall" then
            Arena_Camera.Set_Mode (Arena_Camera.Stalled);
         elsif Rest = "on" then
            Arena_Camera.Set_Mode (Arena_Camera.On);
         elsif Rest = "off" then
            Arena_Camera.Set_Mode (Arena_Camera.Off);
         elsif Rest = "garbage" then
            Arena_Camera.Set_Mode (Arena_Camera.Garbage);
         elsif Rest = "mend" then
            Arena_Camera.Mend;
         else
            Obey_Camera (Rest (Rest'First .. Stop - 1),
                         Trim (Rest (Stop .. Rest'Last), Blanks, Blanks));
         end if;

      elsif Name = "status" then
         No_More (Rest);
         Answer := To_Unbounded_String (Status);
      elsif Name = "journal" then
         if Rest = "" then
            Print_Journal;
            Answer := To_Unbounded_String ("end");
         elsif Rest = "clear" then
            Bench.Clear_Journal;
         else
            raise Bad_Value with "takes nothing, or clear";
         end if;
      elsif Name = "help" then
         No_More (Rest);
         Print_Help;
         Answer := To_Unbounded_String ("end");
      elsif Name = "quit" then
         No_More (Rest);
         Stop_Signals.Stop.Request;
      elsif Name = "" then
         Answer := Null_Unbounded_String;
      else
         raise Bad_Value with "unknown command; try help";
      end if;
   end Obey;

   procedure Obey (Line : String) is
      --  One command and its answer
      Text   : constant String := Trim (Line, Blanks, Blanks);
      Stop   : constant Natural := Index (Text & " ", Blanks);
      Name   : constant String := Text (Text'First .. Stop - 1);
      Answer : Unbounded_String := To_Unbounded_String ("ok");
   begin
      Obey (Name, Trim (Text (Stop .. Text'Last), Blanks, Blanks), Answer);
      if Answer /= "" then
         Say (To_String (Answer));
      end if;
   exception
      when Problem : Bad_Value =>
         Say ("error: " & (if Name = "" then "" else Name & ": ")
              & Ada.Exceptions.Exception_Message (Problem));
   end Obey;

   task body Reader is
      Room  : constant := 4_096;

      Data     : String (1 .. Room);
      Line     : String (1 .. Room) := (others => ' ');
      Length   : Natural := 0;
      Too_Long : Boolean := False;
      Received : long;
   begin
      accept Start;
      loop
         if Polls.Is_Readable (Standard_Input, An_Hour) then
            Received := Libc.Read (Standard_Input, Data'Address, Room);
            exit when Received <= 0;
            for C of Data (1 .. Natural (Received)) loop
               if C = ASCII.LF then
                  if Too_Long then
                     Say ("error: the line is too long");
                  else
                     Obey (Line (1 .. Length));
                  end if;
                  Length   := 0;
                  Too_Long := False;
               elsif Length < Room then
                  Length := Length + 1;
                  Line (Length) := C;
               else
                  Too_Long := True;
               end if;
            end loop;
         end if;
      end loop;
   end Reader;

   procedure Say (Line : String) is
      Text  : constant String := Line & ASCII.LF;
      First : Positive := Text'First;
      Sent  : long;
      Files : Libc.Poll_Array (1 .. 1) :=
        (1 => (Standard_Output, Libc.Poll_Out, 0));
   begin
      while First <= Text'Last loop
         Polls.Wait (Files, An_Hour);
         Sent := Libc.Write (Standard_Output, Text (First)'Address,
                             size_t (Text'Last - First + 1));
         exit when Sent <= 0;
         --  Nobody reads it any more
         First := First + Positive (Sent);
      end loop;
   end Say;

   procedure Start is
   begin
      Reader.Start;
   end Start;

end Bench_Console;
