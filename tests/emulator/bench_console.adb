--  SPDX-License-Identifier: GPL-3.0-or-later
--  The commands on standard input.

with Ada.Characters.Handling; use Ada.Characters.Handling;
with Ada.Exceptions;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Maps;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Interfaces.C;          use Interfaces.C;

with Arena_Camera;
with Instants;              use Instants;
with Journals;
with Libc;
with Plain_Numbers;         use Plain_Numbers;
with Polls;
with Robot_Bench;           use Robot_Bench;
with Robot_Core;
with Robot_Motion;
with Serial_Side;
with Settings;              use Settings;
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

   function Bytes (Text : String) return Robot_Core.Octets is
      --  Characters, with the usual escapes \r, \n, \\ and \xHH
      Most   : constant := 256;
      Result : Robot_Core.Octets (1 .. Text'Length);
      Last   : Natural := 0;
      Next   : Positive := Text'First;
   begin
      while Next <= Text'Last loop
         Last := Last + 1;
         if Text (Next) /= '\' then
            Result (Last) := Character'Pos (Text (Next));
         else
            Next := Next + 1;
            case Text (Next) is
               when 'r' => Result (Last) := 16#0D#;
               when 'n' => Result (Last) := 16#0A#;
               when '\' => Result (Last) := Character'Pos ('\');
               when 'x' =>
                  Result (Last) := Robot_Core.Octet'Value
                    ("16#" & Text (Next + 1 .. Next + 2) & "#");
                  Next := Next + 2;
               when others => raise Constraint_Error;
            end case;
         end if;
         Next := Next + 1;
      end loop;
      if Last not in 1 .. Most then
         raise Constraint_Error;
      end if;
      return Result (1 .. Last);
   exception
      when Constraint_Error =>
         raise Bad_Value with
           "1 to 256 bytes are expected, after a backslash r, n, \ or xHH";
   end Bytes;

   function Decimal (Value : Robot_Motion.Micro; Unit : Positive)
     return String
   is (Plain_Numbers.Rounded (Float (Value) / Float (Unit), 3));
   --  Value / Unit with three decimals

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

   Help : constant String :=
     Settings.Names ("")
     & "mend                   no fault of the line any more" & ASCII.LF
     & "unasked BYTES          sends them now; \r, \n, \\, \xHH" & ASCII.LF
     & "hangup                 the device goes away" & ASCII.LF
     & "return                 and comes back, as a new one" & ASCII.LF
     & "device                 its path" & ASCII.LF
     & "reset-robot            switches it off and on" & ASCII.LF
     & "starve                 its watchdog, if on, disables it" & ASCII.LF
     & "camera on|off|stall    off: closed; stall: no image comes" & ASCII.LF
     & "camera garbage         what comes is no image" & ASCII.LF
     & "camera mend            on, and all of it as at first" & ASCII.LF
     & "camera size ...        also fps, opening and delay" & ASCII.LF
     & "status                 one line" & ASCII.LF
     & "journal                every command since it was cleared" & ASCII.LF
     & "journal clear" & ASCII.LF
     & "quit                   as SIGTERM does" & ASCII.LF
     & "and silent, endless and charge take on or off";

   function Status return String is
      use type Robot_Core.State_Kind;

      R : Robot_Core.Robot;
      P : Robot_Motion.Pose;

      function Switch (Value : Boolean) return String is
        (if Value then "on" else "off");
   begin
      Bench.Look (R, Now, Ago => 0);
      P := Robot_Core.Pose (R);
      return "state=" & Journals.Image (Robot_Core.State (R))
        & " x=" & Decimal (P.X, 10_000)
        & " y=" & Decimal (P.Y, 10_000)
        & " heading=" & Decimal (P.Angle, 1_000_000)
        & " moving="
        & (if Robot_Core.State (R) = Robot_Core.Movement then "1" else "0")
        & " watchdog=" & Switch (Robot_Core.Watchdog_On (R))
        & " missed=" & Image (Robot_Core.Missed (R))
        & " missed_total=" & Image (Robot_Core.Missed_Total (R))
        & " disabled_count=" & Image (Robot_Core.Disabled_Count (R))
        & " battery="
        & (case Robot_Core.Battery (R) is
              when Robot_Core.Critical => "critical",
              when Robot_Core.Empty    => "0",
              when Robot_Core.Low      => "1",
              when Robot_Core.Full     => "2")
        & " commands=" & Image (Robot_Core.Commands (R))
        & " stops=" & Image (Robot_Core.Stops (R))
        & " spoilt=" & Image (Bench.Spoilt)
        & " charging=" & Switch (Robot_Core.Charging (R))
        & " device=" & Serial_Side.Ask (Serial_Side.Name)
        & " viewers=" & Image (Arena_Camera.Viewers)
        & " frames=" & Image (Arena_Camera.Frames);
   end Status;

   procedure Must_Be (Outcome : String) is
      --  Bad_Value unless it is ""
   begin
      if Outcome /= "" then
         raise Bad_Value with Outcome;
      end if;
   end Must_Be;

   procedure Obey (Name, Rest : String; Answer : in out Unbounded_String) is
      --  The same; Bad_Value says what is wrong. Answer: if not "ok".
      Stop  : constant Natural := Index (Rest & " ", Blanks);
      Known : Boolean;

      procedure Say_Device is
      begin
         Answer := To_Unbounded_String
           ("ok device " & Serial_Side.Ask (Serial_Side.Name));
      end Say_Device;

   begin
      Settings.Set (Name, Rest, Known);
      if Known then
         return;
      elsif Name = "camera" then
         for Mode in Arena_Camera.Mode_Kind loop
            if Rest = To_Lower (Mode'Image) then
               Arena_Camera.Set
                 (Camera_Mode, Arena_Camera.Mode_Kind'Pos (Mode));
               return;
            end if;
         end loop;
         if Rest = "mend" then
            Arena_Camera.Mend;
            return;
         end if;
         Settings.Set
           ("camera-" & Rest (Rest'First .. Stop - 1),
            Trim (Rest (Stop .. Rest'Last), Blanks, Blanks), Known);
         if not Known then
            raise Bad_Value with "unknown; try help";
         end if;
      elsif Name = "unasked" then
         Must_Be (Serial_Side.Ask (Serial_Side.Send, Bytes (Rest)));
      elsif Name = "journal" and then Rest = "clear" then
         Bench.Clear_Journal;
      elsif Rest /= "" then
         raise Bad_Value with "unknown, or takes no value; try help";
      elsif Name = "mend" then
         Bench.Mend;
      elsif Name = "hangup" then
         Must_Be (Serial_Side.Ask (Serial_Side.Hang));
      elsif Name = "return" then
         Must_Be (Serial_Side.Ask (Serial_Side.Return_Line));
         Say_Device;
      elsif Name = "device" then
         Say_Device;
      elsif Name = "reset-robot" then
         Bench.Switch_On;
      elsif Name = "starve" then
         Bench.Starve;
      elsif Name = "status" then
         Answer := To_Unbounded_String (Status);
      elsif Name = "journal" then
         Print_Journal;
         Answer := To_Unbounded_String ("end");
      elsif Name = "help" then
         Say (Help);
         Answer := To_Unbounded_String ("end");
      elsif Name = "quit" then
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
