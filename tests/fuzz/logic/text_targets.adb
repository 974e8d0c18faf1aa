--  SPDX-License-Identifier: GPL-3.0-or-later
--  Fuzz targets: texts and numbers, and the command line.

with Base64;
with Base64_Texts;
with Command_Lines;
with Expectations;     use Expectations;
with Input_Readers;    use Input_Readers;
with Monitor.Protocol; use Monitor.Protocol;
with Texts;

package body Text_Targets is

   use Bytes; use type Bytes.Byte;
   use type Command_Lines.Option_Kind;
   use type Command_Lines.Request_Kind;

   procedure Arguments (Data : Byte_Array) is
      R       : constant Reader :=
        (Size => Data'Length, Data => Data, Used => 0);
      Line    : constant String := Rest (R);
      First   : Positive := 1;
      Reading : Command_Lines.Reading;

      procedure Give (Argument : String) is
         Text : constant String (1 .. Argument'Length) := Argument;
      begin
         if Text'Length > Texts.Max_Length then
            Command_Lines.Refuse_Long (Reading);
         else
            Command_Lines.Take (Reading, Text);
         end if;
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

   procedure Base64_Texts (Data : Byte_Array) is
      R       : constant Reader :=
        (Size => Data'Length, Data => Data, Used => 0);
      Text    : constant String := Rest (R);
      Shifted : String (Integer'Last - Text'Length .. Integer'Last - 1);
      Decoded : Byte_Array (1 .. Text'Length + 2) := (others => 0);
      --  the last three bytes count whole: Decode's precondition
      Count   : Natural;
      Same    : Natural;
      OK      : Boolean;
      Again   : Boolean;
      Written : String (1 .. Base64.Encoded_Length (Data'Length) + 8) :=
        (others => '*');
      Last    : Natural;
   begin
      Shifted := Text;
      Standard.Base64_Texts.Decode (Shifted, Decoded, Same, Again);
      Standard.Base64_Texts.Decode (Text, Decoded, Count, OK);
      Check (Count = Same and then OK = Again,
             "a text's meaning depends on its index");
      if OK then
         Base64.Encode (Decoded, Count, Written, 1, Last);
         Check (Written (1 .. Last) = Text, "it is not written as read");
      end if;

      Written := (others => '*');
      Base64.Encode (Data, Data'Length, Written, 5, Last);
      Standard.Base64_Texts.Decode (Written (5 .. Last), Decoded, Count, OK);
      Check
        (OK and then Decoded (1 .. Count) = Data, "it is not read as written");
   end Base64_Texts;

   procedure Decimal_Numbers (Data : Byte_Array) is
      R      : Reader := (Size => Data'Length, Data => Data, Used => 0);
      Text   : constant String := Rest (R);
      First  : Integer;
      Last   : Natural;
      Number : Natural := 0;
      Width  : Integer;
      Into   : String (1 .. 64);
   begin
      --  each run of digits, counted the way it is done at school
      First := 1;
      while First <= Text'Last loop
         Last := First - 1;
         Number := 0;
         while Last < Text'Last and then Numbers.Is_Digit (Text (Last + 1))
         loop
            Last := Last + 1;
            Number := Natural'Min
              (Numbers.Number'Last,
               Natural'Min (Number, Numbers.Number'Last / 10 + 1) * 10
               + Numbers.Digit_Value (Text (Last)));
         end loop;
         if Last >= First then
            Check (Numbers.Saturated_Value (Text, First, Last) = Number,
                   "digits are read as another number");
         end if;
         First := Integer'Max (Last, First) + 1;
      end loop;

      Into := (others => '*');
      Last := 0;
      while not Is_Empty (R) and then Into'Last - Last >= Numbers.Max_Digits
      loop
         Take (R, Numbers.Number'First, Numbers.Number'Last, Number);
         Take (R, Numbers.Digit_Count'First, Numbers.Digit_Count'Last, Width);
         First := Last + 1;
         Numbers.Append (Number, Width, Into, Last);
         Check (Numbers.Saturated_Value (Into, First, Last) = Number,
                "a number is not read as written");
         Numbers.Prove_Same_Value (Into, Into, First, Last);
      end loop;
   end Decimal_Numbers;

   procedure Bounded_Texts (Data : Byte_Array) is
      R     : Reader := (Size => Data'Length, Data => Data, Used => 0);
      T     : Texts.Text;
      Room  : Natural;
      Model : String (1 .. 2 * Texts.Max_Length) := (others => ' ');
      Count : Natural range 0 .. Model'Last := 0;
      --  the text as it would be without a bound, its beginning

      procedure Add (Value : String) is
         Part : constant Natural :=
           Natural'Min (Value'Length, Model'Last - Count);
      begin
         Model (Count + 1 .. Count + Part) :=
           Value (Value'First .. Value'First + (Part - 1));
         Count := Natural'Min (Count + Part, Texts.Max_Length);
      end Add;

      Choice : Byte;
   begin
      while not Is_Empty (R) loop
         Take (R, Choice);
         declare
            Long  : constant Natural :=
              (if Choice >= 16#E0# then 40 * (Natural (Choice) - 220)
               else Natural (Choice) / 4);
            Value : String (Integer'Last - Long .. Integer'Last - 1);
            Part  : Integer;
         begin
            for C of Value loop
               Take (R, C);
            end loop;
            case Choice mod 4 is
               when 0 =>
                  Texts.Set (T, Value);
                  Count := 0;
                  Add (Value);
               when 1 =>
                  T := Texts.To_Text (Value);
                  Count := 0;
                  Add (Value);
               when 2 =>
                  Texts.Append (T, Value);
                  Add (Value);
               when others =>
                  Take (R, Integer'First, Integer'Last, Part);
                  Room := Texts.Max_Length - T.Length;
                  Texts.Append (T, Part);
                  declare
                     Image : constant String := Integer'Image (Part);
                     Plain : constant String :=
                       (if Part < 0 then Image
                        else Image (Image'First + 1 .. Image'Last));
                  begin
                     Check
                       (T.Length = Count + Natural'Min (Plain'Length, Room),
                        "a number has too many characters");
                     Add (Plain);
                  end;
            end case;
         end;
         Check (T.Length = Count and then Texts.Image (T) = Model (1 .. Count),
                "a text is not what was put into it");
      end loop;
      Check (Texts.To_Text (Texts.Image (T)).Length = T.Length,
             "a text is not its own image");
   end Bounded_Texts;

end Text_Targets;
