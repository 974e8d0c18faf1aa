--  SPDX-License-Identifier: GPL-3.0-or-later
--  Base64: the vectors of RFC 4648, round trips, and what must be refused.

with Base64;
with Base64_Texts;
with Bytes;            use Bytes;
with Unit_Runs; use Unit_Runs;

procedure Base64_Tests is

   use type Byte;

   Max : constant := 400;

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

   procedure Test_Refused is
      Output : Byte_Array (1 .. Max) := (others => 0);
      Length : Natural;
      OK     : Boolean;
   begin
      for Text of Split
        ("Z|Zg|Zm8|Zm9vY|Zg==" & ASCII.LF
         --  foreign characters, at every place
         & "|Zm9-|Zm_v|Z 9v|*m9v|Zm9vZm" & ASCII.LF & "v|Z"
         & Character'Val (195) & "9vZm9v"
         --  padding elsewhere than at the end, or too much of it
         & "|Zg==Zg==|Zm8=Zm9v|Z===|====|=m9v|Z=9v|Zg=v"
         --  bits left over that are not zero
         & "|Zh==|Zm9=|Zm9vZh==")
      loop
         Base64_Texts.Decode (Text, Output, Length, OK);
         Assert (not OK and then Length = 0, "refused: " & Text);
      end loop;
   end Test_Refused;

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

begin
   Run_Test ("RFC 4648 vectors", Test_Vectors'Access);
   Run_Test ("whole alphabet", Test_Alphabet'Access);
   Run_Test ("refused texts", Test_Refused'Access);
end Base64_Tests;
