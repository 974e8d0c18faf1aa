--  SPDX-License-Identifier: GPL-3.0-or-later
--  Fuzz targets: the command line, and Base64.

with Base64;
with Base64_Texts;
with Command_Lines;
with Expectations;     use Expectations;
with Input_Readers;    use Input_Readers;

package body Text_Targets is

   use Bytes;
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

end Text_Targets;
