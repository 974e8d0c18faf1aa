--  SPDX-License-Identifier: GPL-3.0-or-later
--  The command language of the console and of scripts.

with Ada.Characters.Handling; use Ada.Characters.Handling;
with Ada.Strings.Fixed;       use Ada.Strings.Fixed;
with Ada.Strings.Maps;
with Commands;                use Commands;
with Monitor.Protocol;        use Monitor.Protocol;
with Numerals;

package body Words is

   type Phrase is record
      Words : Unbounded_String;
      Sends : Known_Command;
      Means : Unbounded_String;
   end record;

   function "+" (Text : String) return Unbounded_String
     renames To_Unbounded_String;

   Phrases : constant array (Positive range <>) of Phrase :=
     ((+"open robot", Open_Robot, +"open the line to the robot"),
      (+"close robot", Close_Robot, +"stop the robot, close its line"),
      (+"start", Start_Robot, +"start without watchdog"),
      (+"start watchdog", Start_Robot_Watchdog, +"start with watchdog"),
      (+"reset", Reset_Robot, +"reset the robot"),
      (+"ping", Ping_Robot, +"is it there?"),
      (+"forward", Go_Forward, +"drive until stopped"),
      (+"backward", Go_Backward, +"drive until stopped"),
      (+"left", Go_Left, +"turn until stopped"),
      (+"right", Go_Right, +"turn until stopped"),
      (+"stop", Stop_Robot, +"stop the movement"),
      (+"abort", Abort_Mission, +"stop the mission and the robot"),
      (+"move", Move_Robot, +"N millimetres, backward if negative"),
      (+"turn", Turn_Robot, +"N degrees, to the right if negative"),
      (+"power off", Power_Off_Robot, +"switch the robot off"),
      (+"battery", Get_Battery, +"ask for its level"),
      (+"version", Get_Version, +"ask for the robot's"),
      (+"state", Get_State, +"is it moving?"),
      (+"open camera", Open_Camera, +"images begin to come"),
      (+"close camera", Close_Camera, +"images end"),
      (+"arena", Ask_Arena, +"search it: an image with it drawn"),
      (+"confirm", Confirm_Arena, +"the arena is right"),
      (+"reject", Reject_Arena, +"it is wrong: forget it"),
      (+"position on", Start_Position, +"follow the robot's position"),
      (+"position off", Stop_Position, +"follow it no longer"),
      (+"go px", Go_To_Pixels, +"to a point of the image, in pixels"),
      (+"follow px", Follow_Pixels, +"1 to 64 such points"),
      (+"go", Go_To_Centimetres, +"to a point of the arena, in cm"),
      (+"follow", Follow_Centimetres, +"1 to 64 such points"),
      (+"say", Log_Message, +"TEXT for the supervisor's log"));

   function Label (Name : Known_Command) return Label_Text is
     (Table (Name).Label);

   function Trimmed (Text : String) return String is
     (Trim (Text, Ada.Strings.Both));

   function First_Word (Text : String) return String is
     (if Index (Text, " ") = 0 then Text
      else Text (Text'First .. Index (Text, " ") - 1));

   function Rest (Text : String) return String is
     (Trimmed (Text (Text'First + First_Word (Text)'Length .. Text'Last)));
   --  The text after the first word

   function Spaced (Text : String) return String is
     (if Text = "" then ""
      elsif Rest (Text) = "" then First_Word (Text)
      else First_Word (Text) & " " & Spaced (Rest (Text)));
   --  Text, which is trimmed, with single blanks between words

   function Is_Bare (Text : String) return Boolean is
     (Text'Length >= 4
      and then
        (for all C of Text (Text'First .. Text'First + 3) => C in 'A' .. 'Z')
      and then
        (Text'Length = 4 or else Text (Text'First + 4) = Separator));
   --  Four capitals, alone or before a colon

   function Sending (Text : String) return Action is
     (Kind => Send, Text => +Text, others => <>);

   function Mission_Line (Name : Mission_Command; Points : String)
     return String
   is (Label (Name) & Separator
       & Ada.Strings.Fixed.Translate
           (Spaced (Points), Ada.Strings.Maps.To_Mapping (" ", ";")));
   --  Blanks between the coordinates will do

   function Wrong (Text : String) return Action is
     (Kind => Mistake, Text => +Text, others => <>);

   function Word_Action (Line : String) return Action;
   --  Line is trimmed; Phrase_Action returns Nothing if it is no phrase.
   --  Try_Action and Wait_Action get the line without its first word.

   function Is_Acknowledged (Answer : String) return Boolean is
     (Answer /= ""
      and then (for some N in Known_Command =>
                  Table (N).Reply = Head (Answer, 4)));

   function Is_As_Expected (Answer : String; Wanted : String) return Boolean
   is (Answer = Wanted or else Head (Answer, 4) = Wanted);

   function Is_Understood (Line : String) return Boolean is
      --  The supervisor takes it
      C : Command;
   begin
      Parse (Line, C);
      return C.Name /= Malformed;
   end Is_Understood;

   procedure List (Put_Line : not null access procedure (Line : String)) is

      procedure Put_Entry (Word, Meaning : String) is
      begin
         Put_Line.all ("  " & Head (Word, 18) & Meaning);
      end Put_Entry;

      function Data (Name : Known_Command) return String is
        (case Table (Name).Data is
            when None                     => "",
            when Number                   => " N",
            when Commands.Text            => " TEXT",
            when Pixel_Point | Arena_Point => " X;Y",
            when Pixel_Path | Arena_Path  => " X;Y;...");

   begin
      for P of Phrases loop
         Put_Entry
           (To_String (P.Words) & Data (P.Sends),
            Label (P.Sends) & "  " & To_String (P.Means));
      end loop;
      Put_Entry ("ABCD[:DATA]", "send that line as it stands");
      Put_Entry ("save [FILE]", "save the latest image");
      Put_Entry ("wait S", "S seconds, decimals allowed");
      Put_Entry ("wait WHAT", "for the next image, position, battery, or");
      Put_Entry ("", "robot (a position with a robot in it); wait mission:");
      Put_Entry ("", "for its end, fail if it was aborted. In a script fail");
      Put_Entry ("", "at once if the last command was refused");
      Put_Entry ("expect ANSWER", "fail unless it was the last: AACK, RBLV:2");
      Put_Entry ("try N COMMAND", "up to N times, 200 ms apart, until it is");
      Put_Entry ("", "acknowledged");
      Put_Entry ("help, quit, #", "this list, the end, a comment");
   end List;

   function Name (Class : Message_Class) return String is
     (To_Lower (Message_Class'Image (Class)));

   function Phrase_Action (Line : String) return Action is
      Lower  : constant String := To_Lower (Line);
      Number : Integer;
      OK     : Boolean;
   begin
      for P of Phrases loop
         if Table (P.Sends).Data = Commands.Text then
            if First_Word (Lower) = P.Words then
               return Sending (Label (P.Sends) & Separator & Rest (Line));
            end if;

         elsif Takes_Number (P.Sends) then
            if First_Word (Lower) = P.Words then
               Numerals.Read
                 (Rest (Line), Integer'First, Integer'Last, Number, OK);
               return
                 (if OK then Sending
                    (Label (P.Sends) & Separator & Numerals.Image (Number))
                  else Wrong
                    (To_String (P.Words) & " wants a whole number"));
            end if;

         elsif P.Sends in Mission_Command then
            if Head (Spaced (Lower), Length (P.Words) + 1) = P.Words & " "
            then
               declare
                  Text : constant String := Spaced (Line);
                  Sent : constant String := Mission_Line
                    (P.Sends,
                     Text (Text'First + Length (P.Words) + 1 .. Text'Last));
               begin
                  return
                    (if Is_Understood (Sent) then Sending (Sent)
                     else Wrong
                       (To_String (P.Words) & " wants "
                        & (if Most_Points (P.Sends) = 1 then "X;Y"
                           else "1 to 64 points X;Y;...")));
               end;
            end if;

         elsif Spaced (Lower) = P.Words then
            return Sending (Label (P.Sends));
         end if;
      end loop;
      return (Kind => Nothing, others => <>);
   end Phrase_Action;

   function Translate (Line : String) return Action is
      Blanks : constant Ada.Strings.Maps.Character_Mapping :=
        Ada.Strings.Maps.To_Mapping (ASCII.HT & ASCII.CR, "  ");
      Text   : constant String :=
        Trimmed (Ada.Strings.Fixed.Translate (Line, Blanks));
   begin
      if Text = "" or else Text (Text'First) = '#' then
         return (Kind => Nothing, others => <>);
      elsif Is_Bare (Text)
        and then
          (Text'Length > 4
           or else (for some K in Known_Command => Label (K) = Text))
      then
         return Sending (Text);
      end if;

      return A : Action := Phrase_Action (Text) do
         if A.Kind = Nothing then
            A := Word_Action (Text);
         end if;
         if A.Kind = Mistake and then Is_Bare (Text) then
            A := Sending (Text);
         end if;
      end return;
   end Translate;

   function Try_Action (Line : String) return Action is
      Count : Integer;
      OK    : Boolean;
      Tried : Action;
   begin
      Numerals.Read (First_Word (Line), 1, 10_000, Count, OK);
      if not OK then
         return Wrong ("try wants a number, 1 to 10000, and a command");
      end if;

      Tried := Translate (Rest (Line));
      if Tried.Kind /= Send or else Tried.Attempts > 1 then
         return Wrong ("try wants a command for the supervisor");
      end if;

      Tried.Attempts := Count;
      return Tried;
   end Try_Action;

   function Wait_Action (Line : String) return Action is
      Seconds : Duration;
      OK      : Boolean;
   begin
      for Class in Message_Class loop
         if To_Upper (Line) = Message_Class'Image (Class) then
            return (Kind => Wait_Message, Awaited => Class, others => <>);
         end if;
      end loop;

      Numerals.Read (Line, Seconds, OK);
      return
        (if OK then (Kind => Pause, Seconds => Seconds, others => <>)
         else Wrong
           ("wait wants seconds, image, position, robot, battery or "
            & "mission"));
   end Wait_Action;

   function Word_Action (Line : String) return Action is
      Word : constant String := To_Lower (First_Word (Line));
      Data : constant String := Rest (Line);
   begin
      if Word = "wait" then
         return Wait_Action (Data);
      elsif Word = "try" then
         return Try_Action (Data);
      elsif Word = "save" then
         return (Kind => Save, Text => +Data, others => <>);
      elsif Word = "expect" and then Data /= "" then
         return (Kind => Expect, Text => +To_Upper (Data), others => <>);
      elsif Line = "help" or else Line = "?" then
         return (Kind => Help, others => <>);
      elsif Line = "quit" or else Line = "exit" then
         return (Kind => Quit, others => <>);
      else
         return Wrong ("not understood: " & Line);
      end if;
   end Word_Action;

end Words;
