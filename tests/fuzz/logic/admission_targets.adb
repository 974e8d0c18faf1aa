--  SPDX-License-Identifier: GPL-3.0-or-later
--  Fuzz targets: who is admitted.

with Ada.Strings;       use Ada.Strings;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Ada.Strings.Maps.Constants; use Ada.Strings.Maps.Constants;
with Admission;
with Expectations;      use Expectations;
with Input_Readers;     use Input_Readers;
with Interfaces;        use Interfaces;
with Networks;
with Texts;

package body Admission_Targets is

   use Bytes;
   use type Admission.Verdict;
   use type Networks.Network;

   function Image (N : Networks.Network) return String is
      --  ADDRESS/LEN
      function Number (Value : Integer) return String is
        (Trim (Integer'Image (Value), Both));

      function Octet (Place : Natural) return String is
        (Number (Integer (Shift_Right (N.Start, 8 * (3 - Place)) and 255)));
   begin
      return Octet (0) & "." & Octet (1) & "." & Octet (2) & "." & Octet (3)
        & "/" & Number (N.Length);
   end Image;

   procedure Take_Part (R : in out Reader; Last : out Natural) is
      --  Takes all up to a NUL and the NUL: the input up to Last, and what has
      --  been taken before
      C : Character;
   begin
      Last := R.Used;
      while not Is_Empty (R) loop
         Take (R, C);
         exit when C = ASCII.NUL;
         Last := R.Used;
      end loop;
   end Take_Part;

   procedure Network_Lists (Data : Byte_Array) is
      R      : Reader := (Size => Data'Length, Data => Data, Used => 0);
      Text   : constant String := Rest (R);
      First  : Positive := 1;
      Last   : Natural;
      L      : Networks.List;

      procedure Read (Line : String) is
         Plain : constant String (1 .. Line'Length) := Line;
         N     : Networks.Network;
         Again : Networks.Network;
         Good  : Boolean;
      begin
         Networks.Parse (Plain, N, Good);
         if Good then
            Networks.Parse (Image (N), Again, Good);
            Check
              (Good and then Again = N
               and then (Image (N) = Plain or else Image (N) = Plain & "/32"),
               "a network is not read as written");
            if L.Count < Networks.Max_Networks then
               L.Count := L.Count + 1;
               L.Items (L.Count) := N;
            end if;
         end if;
      end Read;

      procedure Meet is
         --  A peer
         P       : Byte_Array (1 .. 16);
         A       : Unsigned_32 := 0;
         Mapped  : Boolean;
         Inside  : Boolean := L.Count = 0;
         Mask    : Unsigned_32;
      begin
         for Octet of P loop
            Take (R, Octet);
         end loop;
         Mapped := P (1 .. 12) = (1 .. 10 => 0, 11 .. 12 => 255);
         for I in 13 .. 16 loop
            A := 256 * A + Unsigned_32 (P (I));
         end loop;
         for I in 1 .. L.Count loop
            Mask :=
              (if L.Items (I).Length = 0 then 0
               else Shift_Left (16#FFFF_FFFF#, 32 - L.Items (I).Length));
            if Mapped and then (A and Mask) = L.Items (I).Start then
               Inside := True;
            end if;
         end loop;
         Check (Networks.Admits (L, P) = Inside,
                "somebody else is admitted");
      end Meet;

   begin
      Take_Part (R, Last);
      for I in 1 .. Last loop
         if Text (I) = ASCII.LF then
            Read (Text (First .. I - 1));
            First := I + 1;
         end if;
      end loop;
      Read (Text (First .. Last));
      while not Is_Empty (R) loop
         Meet;
      end loop;
   end Network_Lists;

   procedure Tokens (Data : Byte_Array) is
      R     : Reader := (Size => Data'Length, Data => Data, Used => 0);
      Text  : constant String := Rest (R);
      Last  : Natural;
      T     : Admission.Token;

      procedure Show (Line : String) is
         --  In the log nothing of Line stands behind the first label, in
         --  whatever letters
         Label : constant Natural :=
           Index (Line, Admission.Label, Mapping => Upper_Case_Map);
         Log   : Texts.Text;
      begin
         Texts.Set (Log, "> ");
         Admission.Append_Shown (Log, Line);
         Check (Texts.Image (Log) =
                  Texts.Image
                    (Texts.To_Text
                       ("> "
                        & (if Label = 0 then Line
                           else Line (Line'First .. Label + 4) & "..."))),
                "the log shows what it must not");
      end Show;

      procedure Greet (Sent : String) is
         --  A newcomer that says so
         Line     : constant String :=
           Admission.Label & T.Data (1 .. T.Length);
         Newcomer : Admission.Reader;
      begin
         for C of Sent loop
            exit when Admission.Decision (Newcomer, T) /=
              Admission.Undecided;
            Newcomer.Length := Newcomer.Length + 1;
            Newcomer.Data (Newcomer.Length) := C;
         end loop;
         Check ((Admission.Decision (Newcomer, T) =
                   Admission.Right) =
                  (Head (Sent, Line'Length + 1) = Line & ASCII.LF
                   or else Head (Sent, Line'Length + 2) =
                     Line & ASCII.CR & ASCII.LF),
                "a token is taken for another");
         Check
           (Newcomer.Length in Sent'Length | Admission.Max_Line
            or else Sent (Sent'First + Newcomer.Length - 1) = ASCII.LF,
            "a newcomer is judged too early");
      end Greet;

   begin
      Take_Part (R, Last);
      Admission.Read_Token (Text (1 .. Last), T);
      if T.Length = 0 then
         Admission.Read_Token ("0123456789abcdef", T);
         Check (T.Length = 16, "a token is refused");
      end if;
      declare
         Sent : constant String := Rest (R);
      begin
         Greet (Sent);
         Greet
           (Admission.Label & T.Data (1 .. T.Length) & Sent);
         Show (Sent);
         Show ("x" & Admission.Label & Sent);
      end;
   end Tokens;

end Admission_Targets;
