--  SPDX-License-Identifier: GPL-3.0-or-later
--  Base64: the vectors of RFC 4648, round trips, and what must be refused.

with Ada.Numerics.Discrete_Random;

with AUnit.Assertions; use AUnit.Assertions;

with Base64;
with Base64_Texts;
with Bytes;            use Bytes;
with Unit_Runs; use Unit_Runs;

package body Base64_Tests is

   use type Byte;

   Max : constant := 400;

   package Random_Bytes is new Ada.Numerics.Discrete_Random (Byte);

   function To_Bytes (S : String) return Byte_Array is
      --  The characters' codes, from index 1 on.
      Result : Byte_Array (1 .. S'Length);
   begin
      for I in Result'Range loop
         Result (I) := Character'Pos (S (S'First + I - 1));
      end loop;
      return Result;
   end To_Bytes;

   function Encoded (Input : Byte_Array) return String is
      --  What Encode writes.
      Output : String (1 .. Base64.Encoded_Length (Input'Length));
      Last   : Natural;
   begin
      Output := (others => '#');
      Base64.Encode (Input, Input'Length, Output, 1, Last);
      Assert (Last = Output'Last, "length of the encoding");
      return Output;
   end Encoded;

   procedure Check_Decode (Text : String; Expected : String) is
      --  Text decodes to Expected.
      Output : Byte_Array (1 .. Max) := (others => 255);
      Length : Natural;
      OK     : Boolean;
   begin
      Base64_Texts.Decode (Text, Output, Length, OK);
      Assert (OK and then Length = Expected'Length
              and then Output (1 .. Length) = To_Bytes (Expected),
              "decode " & Text);
      Assert ((for all I in Length + 1 .. Max => Output (I) = 255),
              "behind the result of " & Text);
   end Check_Decode;

   procedure Check_Refused (Text : String) is
      --  Text is no encoding, and Output is left alone as far as Length says.
      Output : Byte_Array (1 .. Max) := (others => 0);
      Length : Natural;
      OK     : Boolean;
   begin
      Base64_Texts.Decode (Text, Output, Length, OK);
      Assert (not OK and then Length = 0, "refused: " & Text);
   end Check_Refused;

   procedure Check_Round_Trip (Input : Byte_Array) is
      --  Decoding the encoding gives Input.
      Text   : constant String := Encoded (Input);
      Output : Byte_Array (1 .. Input'Length + 2) := (others => 0);
      Length : Natural;
      OK     : Boolean;
   begin
      Base64_Texts.Decode (Text, Output, Length, OK);
      Assert (OK and then Length = Input'Length
              and then Output (1 .. Length) = Input,
              "round trip of" & Integer'Image (Input'Length) & " bytes");
   end Check_Round_Trip;

   procedure Test_Alphabet is
      Text   : constant String :=
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
        & "0123456789+/";
      Output : Byte_Array (1 .. 48) := (others => 0);
      Length : Natural;
      OK     : Boolean;
   begin
      Base64_Texts.Decode (Text, Output, Length, OK);
      Assert (OK and then Length = 48, "decoded");
      Assert (Output (1) = 16#00# and then Output (2) = 16#10#
              and then Output (3) = 16#83#, "first three bytes");
      Assert (Output (46) = 16#F3# and then Output (47) = 16#DF#
              and then Output (48) = 16#BF#, "last three bytes");
      Assert (Encoded (Output) = Text, "encoded again");
   end Test_Alphabet;

   procedure Test_Chaos is
      G      : Random_Bytes.Generator;
      Text   : String (1 .. 40);
      Output : Byte_Array (1 .. 30) := (others => 0);
      Length : Natural;
      OK     : Boolean;
      Good   : Natural := 0;
   begin
      Random_Bytes.Reset (G, 4);
      for Round in 1 .. 20_000 loop
         declare
            Size : constant Natural :=
              Natural (Random_Bytes.Random (G)) mod 41;
         begin
            for I in 1 .. Size loop
               Text (I) :=
                 (if Round mod 2 = 0
                  then Character'Val (Random_Bytes.Random (G))
                  else Character'Val
                    (42 + Random_Bytes.Random (G) mod 81));
            end loop;
            Base64_Texts.Decode (Text (1 .. Size), Output, Length, OK);
            if OK then
               Good := Good + 1;
               Assert (Encoded (Output (1 .. Length)) = Text (1 .. Size),
                       "an accepted text is the encoding of its bytes");
            end if;
         end;
      end loop;
      Assert (Good > 0, "some are accepted");
   end Test_Chaos;

   procedure Test_Lengths is
      Input : Byte_Array (1 .. 300);
   begin
      Assert (Base64.Encoded_Length (0) = 0
              and then Base64.Encoded_Length (1) = 4
              and then Base64.Encoded_Length (3) = 4
              and then Base64.Encoded_Length (4) = 8
              and then Base64.Encoded_Length (Base64.Max_Input)
                         = 357_913_944, "lengths");
      for Fill in Byte range 0 .. 2 loop
         Input := (others => Fill * 127 + Fill / 2);
         for Length in 0 .. 300 loop
            Check_Round_Trip (Input (1 .. Length));
         end loop;
      end loop;
   end Test_Lengths;

   procedure Test_Place is
      Output : String (11 .. 40) := (others => '.');
      Last   : Natural;
   begin
      Base64.Encode (To_Bytes ("fooba!"), 5, Output, 16, Last);
      Assert (Last = 23, "last");
      Assert (Output = ".....Zm9vYmE=.................", "text in place");

      --  Up to the very end, and nothing at all behind it

      Base64.Encode (To_Bytes ("foo"), 3, Output, 37, Last);
      Assert (Last = 40 and then Output (37 .. 40) = "Zm9v", "at the end");
      Base64.Encode (To_Bytes ("foo"), 0, Output, 41, Last);
      Assert (Last = 40, "nothing behind the end");
      Assert (Output = ".....Zm9vYmE=.............Zm9v", "rest as it was");
   end Test_Place;

   procedure Test_Refused is
   begin
      --  No multiple of four

      Check_Refused ("Z");
      Check_Refused ("Zg");
      Check_Refused ("Zm8");
      Check_Refused ("Zm9vY");
      Check_Refused ("Zg==" & ASCII.LF);

      --  Foreign characters, at every place

      Check_Refused ("Zm9-");
      Check_Refused ("Zm_v");
      Check_Refused ("Z 9v");
      Check_Refused ("*m9v");
      Check_Refused ("Zm9vZm" & ASCII.LF & "v");
      Check_Refused ("Z" & Character'Val (195) & "9vZm9v");

      --  Padding elsewhere than at the end, or too much of it

      Check_Refused ("Zg==Zg==");
      Check_Refused ("Zm8=Zm9v");
      Check_Refused ("Z===");
      Check_Refused ("====");
      Check_Refused ("=m9v");
      Check_Refused ("Z=9v");
      Check_Refused ("Zg=v");

      --  Bits left over that are not zero

      Check_Refused ("Zh==");
      Check_Refused ("Zm9=");
      Check_Refused ("Zm9vZh==");
   end Test_Refused;

   procedure Test_Two_Characters is
      Output : Byte_Array (1 .. 3) := (others => 0);
      Length : Natural;
      OK     : Boolean;
      Count  : Natural := 0;
   begin
      for A in Character loop
         for B in Character loop
            Base64_Texts.Decode (A & B & "==", Output, Length, OK);
            if OK then
               Count := Count + 1;
               Assert (Length = 1
                       and then Encoded (Output (1 .. 1)) = A & B & "==",
                       "one byte");
            end if;
         end loop;
      end loop;
      Assert (Count = 256, "as many texts as bytes");
   end Test_Two_Characters;

   procedure Test_Vectors is

      procedure Check (Plain, Text : String) is
         --  RFC 4648, section 10, both ways.
      begin
         Assert (Encoded (To_Bytes (Plain)) = Text, "encode " & Plain);
         Check_Decode (Text, Plain);
      end Check;

   begin
      Check ("", "");
      Check ("f", "Zg==");
      Check ("fo", "Zm8=");
      Check ("foo", "Zm9v");
      Check ("foob", "Zm9vYg==");
      Check ("fooba", "Zm9vYmE=");
      Check ("foobar", "Zm9vYmFy");
      Assert (Encoded ((16#FF#, 16#D8#, 16#FF#, 16#E0#)) = "/9j/4A==",
              "how every JPEG begins");
   end Test_Vectors;

   procedure Add_Tests is
   begin
      Add_Test ("RFC 4648 vectors", Test_Vectors'Access);
      Add_Test ("whole alphabet", Test_Alphabet'Access);
      Add_Test ("place in the output", Test_Place'Access);
      Add_Test ("every short length", Test_Lengths'Access);
      Add_Test ("refused texts", Test_Refused'Access);
      Add_Test ("every first two characters", Test_Two_Characters'Access);
      Add_Test ("chaos", Test_Chaos'Access);
   end Add_Tests;

end Base64_Tests;
