--  SPDX-License-Identifier: GPL-3.0-or-later
--  Base64 with padding and without line breaks (RFC 4648, section 4), as
--  the images travel to the monitor.

package body Base64 with SPARK_Mode is

   pragma Assertion_Policy (Loop_Invariant => Ignore);
   --  Each looks at all that is written so far: proved, but at run time
   --  they would make the work quadratic. The contracts are checked.

   Alphabet : constant array (Sextet) of Character :=
     ('A', 'B', 'C', 'D', 'E', 'F', 'G', 'H', 'I', 'J', 'K', 'L', 'M',
      'N', 'O', 'P', 'Q', 'R', 'S', 'T', 'U', 'V', 'W', 'X', 'Y', 'Z',
      'a', 'b', 'c', 'd', 'e', 'f', 'g', 'h', 'i', 'j', 'k', 'l', 'm',
      'n', 'o', 'p', 'q', 'r', 's', 't', 'u', 'v', 'w', 'x', 'y', 'z',
      '0', '1', '2', '3', '4', '5', '6', '7', '8', '9', '+', '/');

   function Letter (Value : Sextet) return Character is (Alphabet (Value))
   with Post => Letter'Result = Symbol (Value);

   procedure Prove_Same_Triple
     (B1, B2, B3, X1, X2, X3 : Byte; C1, C2, C3, C4 : Character)
   with
     Ghost,
     Pre  => Is_Triple (B1, B2, B3, C1, C2, C3, C4)
       and then Is_Triple (X1, X2, X3, C1, C2, C3, C4),
     Post => Natural (B1) = Natural (X1)
       and then Natural (B2) = Natural (X2)
       and then Natural (B3) = Natural (X3);
   --  Four characters stand for one triple of bytes.

   procedure Prove_Same_Sextet (A, B : Sextet)
   with
     Ghost,
     Pre  => Symbol (A) = Symbol (B),
     Post => A = B;
   --  A symbol stands for one value.

   ------------
   -- Decode --
   ------------

   procedure Decode
     (Input  : String;
      Output : in out Byte_Array;
      Length : out Natural;
      OK     : out Boolean)
   is
      Groups : constant Natural := Input'Length / 4;
      First  : constant Positive := Input'First;
      A, B, C, D : Sextet;
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
         if not Is_Symbol (Input (First + 4 * K))
           or else not Is_Symbol (Input (First + 4 * K + 1))
           or else not Is_Symbol (Input (First + 4 * K + 2))
           or else not Is_Symbol (Input (First + 4 * K + 3))
         then
            return;
         end if;
         A := Value_Of (Input (First + 4 * K));
         B := Value_Of (Input (First + 4 * K + 1));
         C := Value_Of (Input (First + 4 * K + 2));
         D := Value_Of (Input (First + 4 * K + 3));
         Output (3 * K + 1) := Byte (A * 4 + B / 16);
         Output (3 * K + 2) := Byte (B mod 16 * 16 + C / 4);
         Output (3 * K + 3) := Byte (C mod 4 * 64 + D);
         pragma Loop_Invariant
           (for all J in 0 .. K =>
              Is_Symbol (Input (First + 4 * J))
              and then Is_Symbol (Input (First + 4 * J + 1))
              and then Is_Symbol (Input (First + 4 * J + 2))
              and then Is_Symbol (Input (First + 4 * J + 3)));
         pragma Loop_Invariant
           (for all J in 0 .. K =>
              Is_Triple
                (Output (3 * J + 1), Output (3 * J + 2), Output (3 * J + 3),
                 Input (First + 4 * J), Input (First + 4 * J + 1),
                 Input (First + 4 * J + 2), Input (First + 4 * J + 3)));
      end loop;

      --  The last four characters, which may be padded

      declare
         Last  : constant Positive := Input'Last;
         Start : constant Natural := 3 * (Groups - 1);
      begin
         if not Is_Symbol (Input (Last - 3))
           or else not Is_Symbol (Input (Last - 2))
         then
            return;
         end if;
         A := Value_Of (Input (Last - 3));
         B := Value_Of (Input (Last - 2));
         if Input (Last) /= '=' then
            if not Is_Symbol (Input (Last - 1))
              or else not Is_Symbol (Input (Last))
            then
               return;
            end if;
            C := Value_Of (Input (Last - 1));
            D := Value_Of (Input (Last));
            Output (Start + 1) := Byte (A * 4 + B / 16);
            Output (Start + 2) := Byte (B mod 16 * 16 + C / 4);
            Output (Start + 3) := Byte (C mod 4 * 64 + D);
            Length := Start + 3;
         elsif Input (Last - 1) /= '=' then
            if not Is_Symbol (Input (Last - 1))
              or else Value_Of (Input (Last - 1)) mod 4 /= 0
            then
               return;
            end if;
            C := Value_Of (Input (Last - 1));
            Output (Start + 1) := Byte (A * 4 + B / 16);
            Output (Start + 2) := Byte (B mod 16 * 16 + C / 4);
            Length := Start + 2;
         else
            if B mod 16 /= 0 then
               return;
            end if;
            Output (Start + 1) := Byte (A * 4 + B / 16);
            Length := Start + 1;
         end if;
      end;
      OK := True;
   end Decode;

   ------------
   -- Encode --
   ------------

   procedure Encode
     (Input  : Byte_Array;
      Length : Natural;
      Output : in out String;
      First  : Positive;
      Last   : out Natural)
   is
      Triples    : constant Natural := Length / 3;
      B1, B2, B3 : Natural range 0 .. 255;
   begin
      for K in 0 .. Triples - 1 loop
         B1 := Natural (Input (3 * K + 1));
         B2 := Natural (Input (3 * K + 2));
         B3 := Natural (Input (3 * K + 3));
         Output (First + 4 * K)     := Letter (B1 / 4);
         Output (First + 4 * K + 1) := Letter (B1 mod 4 * 16 + B2 / 16);
         Output (First + 4 * K + 2) := Letter (B2 mod 16 * 4 + B3 / 64);
         Output (First + 4 * K + 3) := Letter (B3 mod 64);
         pragma Loop_Invariant
           (for all J in 0 .. K =>
              Is_Triple
                (Input (3 * J + 1), Input (3 * J + 2), Input (3 * J + 3),
                 Output (First + 4 * J), Output (First + 4 * J + 1),
                 Output (First + 4 * J + 2), Output (First + 4 * J + 3)));
         pragma Loop_Invariant
           (for all I in Output'Range =>
              (if I < First or else I > First + 4 * K + 3 then
                  Output (I) = Output'Loop_Entry (I)));
      end loop;

      Last := First - 1 + Triples * 4;
      case Length mod 3 is
         when 1 =>
            B1 := Natural (Input (Length));
            Output (Last + 1) := Letter (B1 / 4);
            Output (Last + 2) := Letter (B1 mod 4 * 16);
            Output (Last + 3) := '=';
            Output (Last + 4) := '=';
            Last := Last + 4;
         when 2 =>
            B1 := Natural (Input (Length - 1));
            B2 := Natural (Input (Length));
            Output (Last + 1) := Letter (B1 / 4);
            Output (Last + 2) := Letter (B1 mod 4 * 16 + B2 / 16);
            Output (Last + 3) := Letter (B2 mod 16 * 4);
            Output (Last + 4) := '=';
            Last := Last + 4;
         when others =>
            null;
      end case;
   end Encode;

   ----------------------
   -- Prove_Round_Trip --
   ----------------------

   procedure Prove_Round_Trip (Input : Byte_Array; Length : Natural) is
      Text   : String (1 .. Encoded_Length (Length)) := (others => ' ');
      Result : Byte_Array (1 .. Encoded_Length (Length) / 4 * 3) :=
        (others => 0);
      Last   : Natural;
      Count  : Natural;
      OK     : Boolean;
   begin
      Encode (Input, Length, Text, 1, Last);
      Decode (Text, Result, Count, OK);
      pragma Assert (OK);
      pragma Assert (Count = Length);
      for K in 0 .. Length / 3 - 1 loop
         Prove_Same_Triple
           (Input (3 * K + 1), Input (3 * K + 2), Input (3 * K + 3),
            Result (3 * K + 1), Result (3 * K + 2), Result (3 * K + 3),
            Text (4 * K + 1), Text (4 * K + 2), Text (4 * K + 3),
            Text (4 * K + 4));
         pragma Loop_Invariant
           (for all I in 1 .. 3 * K + 3 =>
              Natural (Result (I)) = Natural (Input (I)));
      end loop;
      pragma Assert
        (for all I in 1 .. Length =>
           Natural (Result (I)) = Natural (Input (I)));
   end Prove_Round_Trip;

   -----------------------
   -- Prove_Same_Sextet --
   -----------------------

   procedure Prove_Same_Sextet (A, B : Sextet) is null;

   -----------------------
   -- Prove_Same_Triple --
   -----------------------

   procedure Prove_Same_Triple
     (B1, B2, B3, X1, X2, X3 : Byte; C1, C2, C3, C4 : Character)
   is
      pragma Unreferenced (C1, C2, C3, C4);
   begin
      Prove_Same_Sextet (Natural (B1) / 4, Natural (X1) / 4);
      Prove_Same_Sextet
        (Natural (B1) mod 4 * 16 + Natural (B2) / 16,
         Natural (X1) mod 4 * 16 + Natural (X2) / 16);
      Prove_Same_Sextet
        (Natural (B2) mod 16 * 4 + Natural (B3) / 64,
         Natural (X2) mod 16 * 4 + Natural (X3) / 64);
      Prove_Same_Sextet (Natural (B3) mod 64, Natural (X3) mod 64);
   end Prove_Same_Triple;

end Base64;
