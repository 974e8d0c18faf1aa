--  SPDX-License-Identifier: GPL-3.0-or-later

package body Base64 with SPARK_Mode is

   pragma Assertion_Policy (Assert => Ignore, Loop_Invariant => Ignore);
   --  Many examine all that is written so far: proved, but at run time they
   --  would make the work quadratic. The contracts are checked.

   Alphabet : constant array (Sextet) of Character :=
     ('A', 'B', 'C', 'D', 'E', 'F', 'G', 'H', 'I', 'J', 'K', 'L', 'M',
      'N', 'O', 'P', 'Q', 'R', 'S', 'T', 'U', 'V', 'W', 'X', 'Y', 'Z',
      'a', 'b', 'c', 'd', 'e', 'f', 'g', 'h', 'i', 'j', 'k', 'l', 'm',
      'n', 'o', 'p', 'q', 'r', 's', 't', 'u', 'v', 'w', 'x', 'y', 'z',
      '0', '1', '2', '3', '4', '5', '6', '7', '8', '9', '+', '/');

   function Letter (Value : Sextet) return Character is (Alphabet (Value))
   with Post => Letter'Result = Symbol (Value);

   procedure Prove_Symbol (Value : Sextet)
   with
     Ghost,
     Post => Is_Symbol (Symbol (Value))
       and then Value_Of (Symbol (Value)) = Value
       and then Symbol (Value) /= Padding;
   --  Each symbol stands for one value.

   procedure Prove_Group (Input : Byte_Array; Length, K : Natural)
   with
     Ghost,
     Pre  => Is_Input (Input, Length)
       and then K < Encoded_Length (Length) / 4,
     Post =>
       Encoded_At (Input, Length, 4 * K) =
         Symbol (Bits (Input, Length, 3 * K + 1) / 4)
       and then Encoded_At (Input, Length, 4 * K + 1) =
         Symbol (Bits (Input, Length, 3 * K + 1) mod 4 * 16
                 + Bits (Input, Length, 3 * K + 2) / 16)
       and then Encoded_At (Input, Length, 4 * K + 2) =
         (if 3 * K + 2 > Length then Padding
          else Symbol (Bits (Input, Length, 3 * K + 2) mod 16 * 4
                       + Bits (Input, Length, 3 * K + 3) / 64))
       and then Encoded_At (Input, Length, 4 * K + 3) =
         (if 3 * K + 3 > Length then Padding
          else Symbol (Bits (Input, Length, 3 * K + 3) mod 64));
   --  The four characters of group K, counted from 0.

   procedure Prove_Bytes (Text : String; K : Natural)
   with
     Ghost,
     Pre  => Text'Last < Integer'Last and then K < Text'Length / 4,
     Post =>
       Natural (Decoded_At (Text, 3 * K + 1)) =
         Value_Of (Text (Text'First + 4 * K)) * 4
         + Value_Of (Text (Text'First + 4 * K + 1)) / 16
       and then Natural (Decoded_At (Text, 3 * K + 2)) =
         Value_Of (Text (Text'First + 4 * K + 1)) mod 16 * 16
         + Value_Of (Text (Text'First + 4 * K + 2)) / 4
       and then Natural (Decoded_At (Text, 3 * K + 3)) =
         Value_Of (Text (Text'First + 4 * K + 2)) mod 4 * 64
         + Value_Of (Text (Text'First + 4 * K + 3));
   --  The three bytes of group K, counted from 0.

   procedure Prove_Group_Back
     (Input : Byte_Array; Length : Natural; Text : String; K : Natural)
   with
     Ghost,
     Pre  => Is_Input (Input, Length)
       and then Text'First = 1
       and then Text'Last = Encoded_Length (Length)
       and then K < Text'Last / 4
       and then Text (4 * K + 1) = Encoded_At (Input, Length, 4 * K)
       and then Text (4 * K + 2) = Encoded_At (Input, Length, 4 * K + 1)
       and then Text (4 * K + 3) = Encoded_At (Input, Length, 4 * K + 2)
       and then Text (4 * K + 4) = Encoded_At (Input, Length, 4 * K + 3),
     Post =>
       (if 3 * K + 3 <= Length then Are_Symbols_At (Text, K))
       and then Is_Last_Group (Text (4 * K + 1), Text (4 * K + 2),
                               Text (4 * K + 3), Text (4 * K + 4))
       and then (Text (4 * K + 4) = Padding) = (3 * K + 3 > Length)
       and then (Text (4 * K + 3) = Padding) = (3 * K + 2 > Length)
       and then
         Natural (Decoded_At (Text, 3 * K + 1)) = Natural (Input (3 * K + 1))
       and then
         (if 3 * K + 2 <= Length then
             Natural (Decoded_At (Text, 3 * K + 2))
               = Natural (Input (3 * K + 2)))
       and then
         (if 3 * K + 3 <= Length then
             Natural (Decoded_At (Text, 3 * K + 3))
               = Natural (Input (3 * K + 3)));
   --  Group K of an encoding is well-formed and decodes to its bytes.

   procedure Prove_Bits (B1, B2, B3 : Natural)
   with
     Ghost,
     Pre  => B1 <= 255 and then B2 <= 255 and then B3 <= 255,
     Post => B1 / 4 <= 63
       and then B1 mod 4 * 16 + B2 / 16 <= 63
       and then B2 mod 16 * 4 + B3 / 64 <= 63
       and then B1 / 4 * 4 + (B1 mod 4 * 16 + B2 / 16) / 16 = B1
       and then (B1 mod 4 * 16 + B2 / 16) mod 16 * 16
                + (B2 mod 16 * 4 + B3 / 64) / 4 = B2
       and then (B2 mod 16 * 4 + B3 / 64) mod 4 * 64 + B3 mod 64 = B3
       and then (if B2 = 0 then (B1 mod 4 * 16 + B2 / 16) mod 16 = 0)
       and then (if B3 = 0 then (B2 mod 16 * 4 + B3 / 64) mod 4 = 0);
   --  Three bytes cut into four sextets, and joined again.

   procedure Prove_Byte_Back
     (Input : Byte_Array; Length : Natural; Text : String; I : Positive)
   with
     Ghost,
     Pre  => Is_Input (Input, Length)
       and then Text'First = 1
       and then Text'Last = Encoded_Length (Length)
       and then
         (for all P in 0 .. Encoded_Length (Length) - 1 =>
            Text (1 + P) = Encoded_At (Input, Length, P))
       and then I <= Length,
     Post => Natural (Decoded_At (Text, I)) = Natural (Input (I));
   --  The same, byte by byte.

   procedure Prove_Same_Byte (A, B : Byte)
   with
     Ghost,
     Pre  => Natural (A) = Natural (B),
     Post => A = B;

   function Triple_Byte_1 (V1, V2 : Sextet) return Byte is
     (Byte (V1 * 4 + V2 / 16))
   with Post => Natural (Triple_Byte_1'Result) = V1 * 4 + V2 / 16;

   function Triple_Byte_2 (V2, V3 : Sextet) return Byte is
     (Byte (V2 mod 16 * 16 + V3 / 4))
   with Post => Natural (Triple_Byte_2'Result) = V2 mod 16 * 16 + V3 / 4;

   function Triple_Byte_3 (V3, V4 : Sextet) return Byte is
     (Byte (V3 mod 4 * 64 + V4))
   with Post => Natural (Triple_Byte_3'Result) = V3 mod 4 * 64 + V4;
   --  The three bytes of four symbols.

   function Are_Symbols_At (Text : String; K : Natural) return Boolean is
     (Is_Symbol (Text (Text'First + 4 * K))
      and then Is_Symbol (Text (Text'First + 4 * K + 1))
      and then Is_Symbol (Text (Text'First + 4 * K + 2))
      and then Is_Symbol (Text (Text'First + 4 * K + 3)));

   procedure Decode
     (Input  : String;
      Output : in out Byte_Array;
      Length : out Natural;
      OK     : out Boolean)
   is
      Groups         : constant Natural := Input'Length / 4;
      C1, C2, C3, C4 : Character;
      Tail, Start    : Natural;
   begin
      Length := 0;
      OK     := False;
      if Input'Length mod 4 /= 0 then
         return;
      end if;
      if Groups = 0 then
         OK := True;
         return;
      end if;

      for K in 0 .. Groups - 2 loop
         C1 := Input (Input'First + 4 * K);
         C2 := Input (Input'First + 4 * K + 1);
         C3 := Input (Input'First + 4 * K + 2);
         C4 := Input (Input'First + 4 * K + 3);
         if not Is_Symbol (C1)
           or else not Is_Symbol (C2)
           or else not Is_Symbol (C3)
           or else not Is_Symbol (C4)
         then
            pragma Assert (not Are_Symbols_At (Input, K));
            pragma Assert (not Is_Well_Formed (Input));
            return;
         end if;
         Output (3 * K + 1) := Triple_Byte_1 (Value_Of (C1), Value_Of (C2));
         Output (3 * K + 2) := Triple_Byte_2 (Value_Of (C2), Value_Of (C3));
         Output (3 * K + 3) := Triple_Byte_3 (Value_Of (C3), Value_Of (C4));
         pragma Assert (Are_Symbols_At (Input, K));
         Prove_Bytes (Input, K);
         Prove_Same_Byte (Output (3 * K + 1), Decoded_At (Input, 3 * K + 1));
         Prove_Same_Byte (Output (3 * K + 2), Decoded_At (Input, 3 * K + 2));
         Prove_Same_Byte (Output (3 * K + 3), Decoded_At (Input, 3 * K + 3));
         pragma Loop_Invariant
           (for all J in 0 .. K => Are_Symbols_At (Input, J));
         pragma Loop_Invariant
           (for all I in 1 .. 3 * K + 3 =>
              Output (I) = Decoded_At (Input, I));
      end loop;

      --  the last four characters, which may be padded

      Tail  := 4 * (Groups - 1);
      Start := 3 * (Groups - 1);
      pragma Assert (Input'First + Tail + 3 = Input'Last);
      pragma Assert
        (for all K in 0 .. Groups - 2 => Are_Symbols_At (Input, K));
      C1 := Input (Input'First + Tail);
      C2 := Input (Input'First + Tail + 1);
      C3 := Input (Input'First + Tail + 2);
      C4 := Input (Input'First + Tail + 3);
      if not Is_Symbol (C1) or else not Is_Symbol (C2) then
         pragma Assert (not Is_Last_Group (C1, C2, C3, C4));
         pragma Assert (not Is_Well_Formed (Input));
         return;
      end if;
      Prove_Bytes (Input, Groups - 1);
      if C4 /= Padding then
         if not Is_Symbol (C3) or else not Is_Symbol (C4) then
            pragma Assert (not Is_Last_Group (C1, C2, C3, C4));
            pragma Assert (not Is_Well_Formed (Input));
            return;
         end if;
         Output (Start + 3) := Triple_Byte_3 (Value_Of (C3), Value_Of (C4));
         Prove_Same_Byte (Output (Start + 3), Decoded_At (Input, Start + 3));
         Length := Start + 3;
      elsif C3 /= Padding then
         if not Is_Symbol (C3) or else Value_Of (C3) mod 4 /= 0 then
            pragma Assert (not Is_Last_Group (C1, C2, C3, C4));
            pragma Assert (not Is_Well_Formed (Input));
            return;
         end if;
         Length := Start + 2;
      elsif Value_Of (C2) mod 16 = 0 then
         Length := Start + 1;
      else
         pragma Assert (not Is_Last_Group (C1, C2, C3, C4));
         pragma Assert (not Is_Well_Formed (Input));
         return;
      end if;
      pragma Assert (Is_Last_Group (C1, C2, C3, C4));
      pragma Assert (Input'Length / 4 * 3 = Start + 3);
      pragma Assert
        (C3 = Input (Input'Last - 1) and then C4 = Input (Input'Last));
      pragma Assert (Length = Decoded_Length (Input));
      Output (Start + 1) := Triple_Byte_1 (Value_Of (C1), Value_Of (C2));
      Prove_Same_Byte (Output (Start + 1), Decoded_At (Input, Start + 1));
      if Length > Start + 1 then
         Output (Start + 2) := Triple_Byte_2 (Value_Of (C2), Value_Of (C3));
         Prove_Same_Byte (Output (Start + 2), Decoded_At (Input, Start + 2));
      end if;
      pragma Assert
        (for all I in 1 .. Start => Output (I) = Decoded_At (Input, I));
      pragma Assert
        (for all I in Start + 1 .. Length =>
           Output (I) = Decoded_At (Input, I));
      OK := True;
      pragma Assert (Is_Well_Formed (Input));
   end Decode;

   function Decoded_At (Text : String; I : Positive) return Byte is
      P  : constant Positive := Text'First + (I - 1) / 3 * 4;
      V1 : constant Sextet := Value_Of (Text (P));
      V2 : constant Sextet := Value_Of (Text (P + 1));
      V3 : constant Sextet := Value_Of (Text (P + 2));
      V4 : constant Sextet := Value_Of (Text (P + 3));
   begin
      return
        (case (I - 1) mod 3 is
            when 0      => Triple_Byte_1 (V1, V2),
            when 1      => Triple_Byte_2 (V2, V3),
            when others => Triple_Byte_3 (V3, V4));
   end Decoded_At;

   procedure Encode
     (Input  : Byte_Array;
      Length : Natural;
      Output : in out String;
      First  : Positive;
      Last   : out Natural)
   is
      pragma Suppress (All_Checks);
      --  every image passes here: the run-time checks, all proved, would cost
      --  time for each byte

      Triples    : constant Natural := Length / 3;
      N1, N2, N3 : Natural range 0 .. 255;
   begin
      for K in 0 .. Triples - 1 loop
         N1 := Natural (Input (3 * K + 1));
         N2 := Natural (Input (3 * K + 2));
         N3 := Natural (Input (3 * K + 3));
         Output (First + 4 * K)     := Letter (N1 / 4);
         Output (First + 4 * K + 1) := Letter (N1 mod 4 * 16 + N2 / 16);
         Output (First + 4 * K + 2) := Letter (N2 mod 16 * 4 + N3 / 64);
         Output (First + 4 * K + 3) := Letter (N3 mod 64);
         Prove_Group (Input, Length, K);
         pragma Assert
           (for all P in 0 .. 4 * K - 1 =>
              Output (First + P) = Encoded_At (Input, Length, P));
         pragma Assert
           (Output (First + 4 * K) = Encoded_At (Input, Length, 4 * K));
         pragma Assert
           (Output (First + 4 * K + 1)
              = Encoded_At (Input, Length, 4 * K + 1));
         pragma Assert
           (Output (First + 4 * K + 2)
              = Encoded_At (Input, Length, 4 * K + 2));
         pragma Assert
           (Output (First + 4 * K + 3)
              = Encoded_At (Input, Length, 4 * K + 3));
         pragma Assert
           (for all P in 4 * K .. 4 * K + 3 =>
              Output (First + P) = Encoded_At (Input, Length, P));
         pragma Loop_Invariant
           (for all P in 0 .. 4 * K + 3 =>
              Output (First + P) = Encoded_At (Input, Length, P));
         pragma Loop_Invariant
           (for all I in Output'Range =>
              (if I < First or else I > First + 4 * K + 3 then
                  Output (I) = Output'Loop_Entry (I)));
      end loop;

      Last := First - 1 + Triples * 4;
      if Length mod 3 /= 0 then
         pragma Assert (Encoded_Length (Length) = Triples * 4 + 4);
         Prove_Group (Input, Length, Triples);
         N1 := Natural (Input (3 * Triples + 1));
         N2 := (if Length mod 3 = 1 then 0 else Natural (Input (Length)));
         Output (Last + 1) := Letter (N1 / 4);
         Output (Last + 2) := Letter (N1 mod 4 * 16 + N2 / 16);
         Output (Last + 3) :=
           (if Length mod 3 = 1 then Padding else Letter (N2 mod 16 * 4));
         Output (Last + 4) := Padding;
         pragma Assert (Length = 3 * Triples + Length mod 3);
         pragma Assert (Bits (Input, Length, 3 * Triples + 1) = N1);
         pragma Assert
           (if Length mod 3 = 1 then 3 * Triples + 2 > Length
            else 3 * Triples + 2 = Length);
         pragma Assert (Bits (Input, Length, 3 * Triples + 2) = N2);
         pragma Assert (Length < 3 * Triples + 3);
         pragma Assert (Bits (Input, Length, 3 * Triples + 3) = 0);
         for J in 0 .. 3 loop
            pragma Assert
              (Output (Last + 1 + J)
                 = Encoded_At (Input, Length, 4 * Triples + J));
         end loop;
         pragma Assert
           (for all P in 0 .. 4 * Triples - 1 =>
              Output (First + P) = Encoded_At (Input, Length, P));
         pragma Assert
           (for all P in 4 * Triples .. 4 * Triples + 3 =>
              Output (First + P) = Encoded_At (Input, Length, P));
         Last := Last + 4;
      else
         pragma Assert (Encoded_Length (Length) = 4 * Triples);
      end if;
      pragma Assert
        (for all P in 0 .. Encoded_Length (Length) - 1 =>
           Output (First + P) = Encoded_At (Input, Length, P));
   end Encode;

   function Group_Character
     (Input : Byte_Array; Length, K : Natural; J : Place) return Character
   is
      N1 : constant Natural := Bits (Input, Length, 3 * K + 1);
      N2 : constant Natural := Bits (Input, Length, 3 * K + 2);
      N3 : constant Natural := Bits (Input, Length, 3 * K + 3);
   begin
      case J is
         when 0 =>
            return Symbol (N1 / 4);
         when 1 =>
            return Symbol (N1 mod 4 * 16 + N2 / 16);
         when 2 =>
            return (if 3 * K + 2 > Length then Padding
                    else Symbol (N2 mod 16 * 4 + N3 / 64));
         when 3 =>
            return (if 3 * K + 3 > Length then Padding
                    else Symbol (N3 mod 64));
      end case;
   end Group_Character;

   procedure Prove_Bits (B1, B2, B3 : Natural) is
   begin
      pragma Assert ((B1 mod 4 * 16 + B2 / 16) / 16 = B1 mod 4);
      pragma Assert ((B1 mod 4 * 16 + B2 / 16) mod 16 = B2 / 16);
      pragma Assert ((B2 mod 16 * 4 + B3 / 64) / 4 = B2 mod 16);
      pragma Assert ((B2 mod 16 * 4 + B3 / 64) mod 4 = B3 / 64);
   end Prove_Bits;

   procedure Prove_Bytes (Text : String; K : Natural) is null;

   procedure Prove_Byte_Back
     (Input : Byte_Array; Length : Natural; Text : String; I : Positive)
   is
      K : constant Natural := (I - 1) / 3;
   begin
      for J in 0 .. 3 loop
         pragma Assert
           (Text (1 + 4 * K + J) = Encoded_At (Input, Length, 4 * K + J));
      end loop;
      Prove_Group_Back (Input, Length, Text, K);
      case (I - 1) mod 3 is
         when 0      => pragma Assert (I = 3 * K + 1);
         when 1      => pragma Assert (I = 3 * K + 2);
         when others => pragma Assert (I = 3 * K + 3);
      end case;
   end Prove_Byte_Back;

   procedure Prove_Group (Input : Byte_Array; Length, K : Natural) is
   begin
      for J in Place loop
         pragma Assert ((4 * K + J) / 4 = K);
         pragma Assert ((4 * K + J) mod 4 = J);
         pragma Assert
           (Encoded_At (Input, Length, 4 * K + J)
              = Group_Character (Input, Length, K, J));
      end loop;
   end Prove_Group;

   procedure Prove_Group_Back
     (Input : Byte_Array; Length : Natural; Text : String; K : Natural)
   is
      B1 : constant Natural := Bits (Input, Length, 3 * K + 1);
      B2 : constant Natural := Bits (Input, Length, 3 * K + 2);
      B3 : constant Natural := Bits (Input, Length, 3 * K + 3);
      V1 : constant Sextet := B1 / 4;
      V2 : constant Sextet := B1 mod 4 * 16 + B2 / 16;
      V3 : constant Sextet := B2 mod 16 * 4 + B3 / 64;
      V4 : constant Sextet := B3 mod 64;
   begin
      Prove_Bits (B1, B2, B3);
      Prove_Group (Input, Length, K);
      Prove_Bytes (Text, K);
      Prove_Symbol (V1);
      Prove_Symbol (V2);
      Prove_Symbol (V3);
      Prove_Symbol (V4);
      pragma Assert (3 * K + 1 <= Length);
      pragma Assert (Text (4 * K + 1) = Symbol (V1));
      pragma Assert (Text (4 * K + 2) = Symbol (V2));
      if 3 * K + 2 <= Length then
         pragma Assert (Text (4 * K + 3) = Symbol (V3));
      end if;
      if 3 * K + 3 <= Length then
         pragma Assert (Text (4 * K + 4) = Symbol (V4));
      end if;
      pragma Assert (V1 * 4 + V2 / 16 = B1);
      pragma Assert (V2 mod 16 * 16 + V3 / 4 = B2);
      pragma Assert (V3 mod 4 * 64 + V4 = B3);
   end Prove_Group_Back;

   procedure Prove_Round_Trip (Input : Byte_Array; Length : Natural) is
      Text   : String (1 .. Encoded_Length (Length)) := (others => ' ');
      Result : Byte_Array (1 .. Encoded_Length (Length) / 4 * 3) :=
        (others => 0);
      Groups : constant Natural := Encoded_Length (Length) / 4;
      Last   : Natural;
      Count  : Natural;
      OK     : Boolean;
   begin
      Encode (Input, Length, Text, 1, Last);
      for K in 0 .. Groups - 1 loop
         for J in 0 .. 3 loop
            pragma Assert
              (Text (1 + 4 * K + J) = Encoded_At (Input, Length, 4 * K + J));
         end loop;
         Prove_Group_Back (Input, Length, Text, K);
         pragma Loop_Invariant
           (for all J in 0 .. K =>
              (if 3 * J + 3 <= Length then Are_Symbols_At (Text, J)));
         pragma Loop_Invariant
           (Is_Last_Group (Text (4 * K + 1), Text (4 * K + 2),
                           Text (4 * K + 3), Text (4 * K + 4)));
         pragma Loop_Invariant
           ((Text (4 * K + 4) = Padding) = (3 * K + 3 > Length));
         pragma Loop_Invariant
           ((Text (4 * K + 3) = Padding) = (3 * K + 2 > Length));
      end loop;
      pragma Assert (Text'Last = 4 * Groups);
      pragma Assert (Length <= Text'Length / 4 * 3);
      for I in 1 .. Length loop
         Prove_Byte_Back (Input, Length, Text, I);
         pragma Loop_Invariant
           (for all J in 1 .. I =>
              Natural (Decoded_At (Text, J)) = Natural (Input (J)));
      end loop;
      pragma Assert (if Groups > 0 then 3 * (Groups - 1) < Length);
      pragma Assert (if Groups > 0 then 4 * (Groups - 1) + 1 = Text'Last - 3);
      pragma Assert
        (for all K in 0 .. Groups - 2 => Are_Symbols_At (Text, K));
      pragma Assert
        (if Groups > 0 then
            Is_Last_Group (Text (Text'Last - 3), Text (Text'Last - 2),
                           Text (Text'Last - 1), Text (Text'Last)));
      pragma Assert (Is_Well_Formed (Text));
      pragma Assert
        (if Length mod 3 = 0 then Groups = Length / 3
         else Groups = Length / 3 + 1);
      pragma Assert
        (if Groups > 0 then
           (Text (Text'Last) = Padding) = (3 * Groups > Length)
           and then
             (Text (Text'Last - 1) = Padding) = (3 * Groups > Length + 1));
      pragma Assert (Decoded_Length (Text) = Length);
      Decode (Text, Result, Count, OK);
      pragma Assert (OK);
      pragma Assert (Count = Length);
      pragma Assert
        (for all I in 1 .. Length =>
           Natural (Result (I)) = Natural (Input (I)));
   end Prove_Round_Trip;

   procedure Prove_Same_Byte (A, B : Byte) is null;

   procedure Prove_Symbol (Value : Sextet) is null;

end Base64;
