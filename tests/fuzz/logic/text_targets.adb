--  SPDX-License-Identifier: GPL-3.0-or-later
--  Fuzz targets: what comes from the monitor, and the command line.

with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Command_Lines;
with Commands;          use Commands;
with Expectations;      use Expectations;
with Input_Readers;     use Input_Readers;
with Missions;
with Monitor.Protocol;  use Monitor.Protocol;
with Texts;

package body Text_Targets is

   use type Command_Lines.Option_Kind;
   use type Command_Lines.Request_Kind;

   function Are_Points (Text : String; Most : Positive) return Boolean is
      --  1 to Most points. Said in another way than Is_Path does
      type Place is (Sign, Whole, Point, Part);
      --  what has come last of a coordinate

      Last   : Place := Sign;
      Signed : Boolean := False;
      Wholes : Natural := 0;
      Parts  : Natural := 0;
      Fields : Natural := 0;
   begin
      for C of String'(Text & ';') loop
         case C is
            when '0' .. '9' =>
               if Last in Point | Part then
                  Last := Part;
                  Parts := Parts + 1;
               else
                  Last := Whole;
                  Wholes := Wholes + 1;
               end if;
            when '-' =>
               if Signed or else Last /= Sign then
                  return False;
               end if;
               Signed := True;
            when '.' =>
               if Last /= Whole then
                  return False;
               end if;
               Last := Point;
            when ';' =>
               if Last not in Whole | Part or else Wholes > 7
                 or else Parts > 6
               then
                  return False;
               end if;
               Fields := Fields + 1;
               Last := Sign;
               Signed := False;
               Wholes := 0;
               Parts := 0;
            when others =>
               return False;
         end case;
      end loop;
      return Fields mod 2 = 0 and then Fields <= 2 * Most;
   end Are_Points;

   function Meaning (Line : String) return Command is
      --  That, said in another way than Parse does
      Colon  : constant Natural := Index (Line, ":");
      Start  : constant String :=
        (if Colon = 0 then Line else Line (Line'First .. Colon - 1));
      Text   : constant String :=
        (if Colon = 0 then "" else Line (Colon + 1 .. Line'Last));
      Kind   : Command_Name := Malformed;
      Value  : Integer := 0;
      Signed : Boolean;
   begin
      for K in Known_Command loop
         if Start = Table (K).Label then
            Kind := K;
         end if;
      end loop;
      case Kind is
         when Malformed =>
            null;
         when Log_Message =>
            if Colon = 0 then
               Kind := Malformed;
            end if;
         when Move_Robot | Turn_Robot =>
            Signed := Text'Length > 0 and then Text (Text'First) in '+' | '-';
            if Text'Length = Boolean'Pos (Signed) then
               return (Malformed, 0);
            end if;
            for I in Text'First + Boolean'Pos (Signed) .. Text'Last loop
               if Text (I) not in '0' .. '9' then
                  return (Malformed, 0);
               end if;
               Value := Integer'Min
                 (100_000, 10 * Value + Character'Pos (Text (I)) - 48);
            end loop;
            Value :=
              (if Text (Text'First) = '-' then -Integer'Min (Value, 32_768)
               else Integer'Min (Value, 32_767));
         when Mission_Command =>
            if not Are_Points
              (Text, (if Kind in Go_To_Pixels | Go_To_Centimetres then 1
                      else 64))
            then
               Kind := Malformed;
            end if;
         when others =>
            if Text /= "" then
               Kind := Malformed;
            end if;
      end case;
      return (Kind, Value);
   end Meaning;

   procedure Parse_Anywhere (Line : String) is
      --  Line means the same wherever its first index is, and what the table
      --  of the wire format says
      Shifted : String (Integer'Last - Line'Length .. Integer'Last - 1);
      Here    : Command;
      There   : Command;
      Path    : Missions.Path;
      Valid   : Boolean;
      Text    : Texts.Text;
   begin
      Shifted := Line;
      Parse (Line, Here);
      Parse (Shifted, There);
      Check (Here = Meaning (Line), "a line has another meaning");
      Check (Here = There, "a line's meaning depends on its index");
      if Here.Name in Mission_Command then
         Monitor.Protocol.Parse
           (Line, Line'First + Text_Offset, Measure (Here.Name),
            Most_Points (Here.Name), Path, Valid);
         Check (Valid, "a mission has no path");
      end if;
      Texts.Set (Text, "received ");
      Texts.Append (Text, Line);
      if Here.Name = Log_Message then
         Texts.Set (Text, "monitor says: ");
         Texts.Append (Text, Line (Line'First + Text_Offset .. Line'Last));
      end if;
   end Parse_Anywhere;

   function Is_Plain (Line : String) return Boolean is
     (for all C of Line => C not in Line_Feed | Telnet_Mark);

   procedure Lines (Data : Bytes.Byte_Array) is
      Reader   : Line_Reader;
      Line     : Line_Buffer := (others => ' ');
      Last     : Line_Length;
      Complete : Boolean;
      Begun    : Positive := 1;
      --  where the line under way began, in All_Text
      Ended    : Natural;
      R        : constant Input_Readers.Reader :=
        (Size => Data'Length, Data => Data, Used => 0);
      All_Text : constant String := Rest (R);
   begin
      for I in All_Text'Range loop
         Accept_Character (Reader, All_Text (I), Complete);
         if Complete then
            Get_Line (Reader, Line, Last);
            Reader := (others => <>);
            Ended := I - 1;
            if Ended >= Begun and then All_Text (Ended) = Carriage_Return then
               Ended := Ended - 1;
            end if;
            if Ended - Begun + 1 > Max_Line then
               Check (Last = 0, "a line that is too long is not empty");
            elsif Is_Plain (All_Text (Begun .. Ended)) then
               Check (Line (1 .. Last) = All_Text (Begun .. Ended),
                      "a line is not what came");
            end if;
            Parse_Anywhere (Line (1 .. Last));
            Begun := I + 1;
         end if;
      end loop;
      --  Parse takes more than a reader gives: any length, any character
      Parse_Anywhere (All_Text);
   end Lines;

   procedure Arguments (Data : Bytes.Byte_Array) is
      R       : constant Reader :=
        (Size => Data'Length, Data => Data, Used => 0);
      Line    : constant String := Rest (R);
      First   : Positive := 1;
      Reading : Command_Lines.Reading;

      procedure Give (Argument : String) is
         Text : constant String (1 .. Argument'Length) := Argument;
      begin
         Command_Lines.Take (Reading, Text);
         Check (Reading.Request in Command_Lines.Settled_Kind
                or else Reading.Reason.Length = 0,
                "a reason without a refusal");
      end Give;

   begin
      for I in Line'Range loop
         if Line (I) in ASCII.NUL | ASCII.LF then
            Give (Line (First .. I - 1));
            First := I + 1;
         end if;
      end loop;
      if First <= Line'Last then
         Give (Line (First .. Line'Last));
      end if;
      Command_Lines.Finish (Reading);
      Check ((Reading.Request = Command_Lines.Wrong)
               = (Reading.Reason.Length > 0),
             "a refusal without a reason");
      Check (Reading.Request not in Command_Lines.Run | Command_Lines.Check
             or else Reading.Awaited = Command_Lines.None,
             "a value is awaited");
      Check (Reading.Request not in Command_Lines.Run | Command_Lines.Check
             or else
               (Reading.Chosen.Bind.Length > 0
                and then Reading.Chosen.Serial.Length > 0
                and then Reading.Chosen.Camera.Length > 0),
             "an option without a value is accepted");
   end Arguments;

end Text_Targets;
