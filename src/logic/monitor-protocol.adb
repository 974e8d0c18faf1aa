--  SPDX-License-Identifier: GPL-3.0-or-later

package body Monitor.Protocol with SPARK_Mode is

   procedure Put_Micro
     (Value  : Micro;
      Buffer : in out Position_Text;
      Last   : in out Natural)
   with
     Pre  => Last <= Max_Position - 20,
     Post => Last in Last'Old + 8 .. Last'Old + 16
       and then (for all I in 1 .. Last'Old => Buffer (I) = Buffer'Old (I))
       and then (for all I in Last'Old + 1 .. Last =>
                   Buffer (I) in '-' | '.' | '0' .. '9')
       and then Reads_As_Micro (Buffer, Last'Old + 1, Last, Value);
   --  Appends Value with six decimals.

   procedure Put_Id
     (Id     : Robot_Id;
      Buffer : in out Position_Text;
      Last   : in out Natural)
   with
     Pre  => Last <= Max_Position - 20,
     Post => Last in Last'Old + 1 .. Last'Old + 3
       and then (for all I in 1 .. Last'Old => Buffer (I) = Buffer'Old (I))
       and then (for all I in Last'Old + 1 .. Last =>
                   Buffer (I) in '-' | '0' .. '9')
       and then Reads_As_Id (Buffer, Last'Old + 1, Last, Id);
   --  Appends Id.

   procedure Put_Field
     (Value  : Micro;
      Buffer : in out Position_Text;
      Last   : in out Natural)
   with
     Pre  => Last <= Max_Position - 21,
     Post => Last in Last'Old + 9 .. Last'Old + 17
       and then (for all I in 1 .. Last'Old => Buffer (I) = Buffer'Old (I))
       and then Buffer (Last'Old + 1) = Field_Separator
       and then (for all I in Last'Old + 2 .. Last =>
                   Buffer (I) in '-' | '.' | '0' .. '9')
       and then Reads_As_Micro (Buffer, Last'Old + 2, Last, Value);
   --  Appends a separator and Value.

   procedure Prove_Same_Micro
     (A, B : String; First : Positive; Last : Natural; Value : Micro)
   with
     Ghost,
     Pre  => A'First = 1
       and then B'First = 1
       and then A'Last <= Max_Position
       and then B'Last <= Max_Position
       and then Last <= Natural'Min (A'Last, B'Last)
       and then Reads_As_Micro (A, First, Last, Value)
       and then (for all I in First .. Last => A (I) = B (I)),
     Post => Reads_As_Micro (B, First, Last, Value);
   --  The value depends only on the characters of the number.

   procedure Prove_Same_Id
     (A, B : String; First : Positive; Last : Natural; Id : Robot_Id)
   with
     Ghost,
     Pre  => A'First = 1
       and then B'First = 1
       and then A'Last <= Max_Position
       and then B'Last <= Max_Position
       and then Last <= Natural'Min (A'Last, B'Last)
       and then Reads_As_Id (A, First, Last, Id)
       and then (for all I in First .. Last => A (I) = B (I)),
     Post => Reads_As_Id (B, First, Last, Id);

   function No_Separator
     (Line : String; First : Positive; Last : Natural) return Boolean
   is (for all I in First .. Last => Line (I) /= Field_Separator)
   with
     Ghost,
     Pre => First >= Line'First and then Last <= Line'Last;

   procedure Prove_Field_End
     (Line : String; First : Positive; Last, Ending : Natural)
   with
     Ghost,
     Pre  => Line'First = 1
       and then Line'Last <= Max_Position
       and then Last <= Line'Last
       and then Ending <= Last
       and then First <= Ending + 1
       and then No_Separator (Line, First, Ending)
       and then (if Ending < Last then
                    Line (Ending + 1) = Field_Separator),
     Post => Field_End (Line, First, Last) = Ending;
   --  The end of a field is unique.

   function Are_Cut
     (Line : String; Last : Natural; S : Field_Starts) return Boolean
   is (S (1) = First_Field
       and then S (7) = Last + 2
       and then S (1) < S (2)
       and then S (2) < S (3)
       and then S (3) < S (4)
       and then S (4) < S (5)
       and then S (5) < S (6)
       and then S (6) < S (7)
       and then Line (S (2) - 1) = Field_Separator
       and then Line (S (3) - 1) = Field_Separator
       and then Line (S (4) - 1) = Field_Separator
       and then Line (S (5) - 1) = Field_Separator
       and then Line (S (6) - 1) = Field_Separator
       and then No_Separator (Line, S (1), S (2) - 2)
       and then No_Separator (Line, S (2), S (3) - 2)
       and then No_Separator (Line, S (3), S (4) - 2)
       and then No_Separator (Line, S (4), S (5) - 2)
       and then No_Separator (Line, S (5), S (6) - 2)
       and then No_Separator (Line, S (6), S (7) - 2))
   with
     Ghost,
     Pre => Line'First = 1
       and then Line'Last <= Max_Position
       and then Last <= Line'Last;
   --  The separators of Line (1 .. Last) cut it into fields that begin at S.

   procedure Prove_Starts (Line : String; Last : Natural; S : Field_Starts)
   with
     Ghost,
     Pre  => Line'First = 1
       and then Line'Last <= Max_Position
       and then Last in First_Field .. Line'Last
       and then Are_Cut (Line, Last, S),
     Post => Starts (Line, Last) = S;
   --  Fields begin as determined by their separators.

   procedure Prove_Position
     (Line : String; Last : Natural; S : Field_Starts; P : Position)
   with
     Ghost,
     Pre  => Line'First = 1
       and then Line'Last <= Max_Position
       and then Last in First_Field .. Line'Last
       and then Begins_With (Line, Position_Label)
       and then Has_Data (Line)
       and then Are_Cut (Line, Last, S)
       and then Are_Fields (Line, Last, S)
       and then Are_Fields_Of (Line, S, P),
     Post => Reads_As (Line, Last, P);
   --  A line whose fields, cut at S, are those of P encodes P.

   procedure Keep (R : in out Line_Reader; C : Character)
   with
     Post => R.Held = R'Old.Held
       and then R.Finished = R'Old.Finished
       and then R.Length = Integer'Min (R'Old.Length + 1, Max_Line)
       and then R.Too_Long =
                  (R'Old.Too_Long or else R'Old.Length = Max_Line)
       and then (for all I in 1 .. R'Old.Length =>
                   R.Data (I) = R'Old.Data (I))
       and then (if R'Old.Length < Max_Line then R.Data (R.Length) = C);
   --  Appends C to the line if there is room; otherwise marks it as too long.

   procedure Accept_Character
     (R : in out Line_Reader; C : Character; Complete : out Boolean)
   is
   begin
      if R.Finished then
         Clear (R);
      end if;
      Complete := C = Line_Feed;
      if Complete then
         R.Finished := True;
         return;
      end if;
      if R.Held then
         R.Held := False;
         Keep (R, Carriage_Return);
      end if;
      if C = Carriage_Return then
         R.Held := True;
      else
         Keep (R, C);
      end if;
   end Accept_Character;

   procedure Clear (R : out Line_Reader) is
   begin
      R := (Data     => (others => ' '),
            Length   => 0,
            Held     => False,
            Too_Long => False,
            Finished => False);
   end Clear;

   function Field_End
     (Line : String; First : Positive; Last : Natural) return Natural
   is
   begin
      for I in First .. Last loop
         if Line (I) = Field_Separator then
            return I - 1;
         end if;
         pragma Loop_Invariant
           (for all J in First .. I => Line (J) /= Field_Separator);
      end loop;
      return Last;
   end Field_End;

   procedure Format_Position
     (P      : Position;
      Buffer : out Position_Text;
      Last   : out Natural)
   is
      S     : Field_Starts := (others => First_Field) with Ghost;
      With_Id, With_Angle, With_Cx, With_Cy, With_Dx, With_Dy :
        Position_Text with Ghost;
      --  position encoded by the line if it ended with this field
   begin
      Buffer := (others => ' ');
      Buffer (1) := Position_Label (1);
      Buffer (2) := Position_Label (2);
      Buffer (3) := Position_Label (3);
      Buffer (4) := Position_Label (4);
      Buffer (5) := Separator;
      Last := 5;
      Put_Id (P.Id, Buffer, Last);
      S (2) := Last + 2;
      With_Id := Buffer;
      pragma Assert (for all I in 1 .. Last => Buffer (I) /= Line_Feed);
      Put_Field (P.Angle, Buffer, Last);
      S (3) := Last + 2;
      With_Angle := Buffer;
      pragma Assert (for all I in 1 .. Last => Buffer (I) /= Line_Feed);
      Put_Field (P.Cx, Buffer, Last);
      S (4) := Last + 2;
      With_Cx := Buffer;
      pragma Assert (for all I in 1 .. Last => Buffer (I) /= Line_Feed);
      Put_Field (P.Cy, Buffer, Last);
      S (5) := Last + 2;
      With_Cy := Buffer;
      pragma Assert (for all I in 1 .. Last => Buffer (I) /= Line_Feed);
      Put_Field (P.Dx, Buffer, Last);
      S (6) := Last + 2;
      With_Dx := Buffer;
      pragma Assert (for all I in 1 .. Last => Buffer (I) /= Line_Feed);
      Put_Field (P.Dy, Buffer, Last);
      S (7) := Last + 2;
      With_Dy := Buffer;
      pragma Assert (for all I in 1 .. Last => Buffer (I) /= Line_Feed);
      Last := Last + 1;
      Buffer (Last) := Line_Feed;

      pragma Assert
        (for all I in 1 .. S (7) - 2 => Buffer (I) = With_Dy (I));
      pragma Assert
        (for all I in 1 .. S (6) - 2 => Buffer (I) = With_Dx (I));
      pragma Assert
        (for all I in 1 .. S (5) - 2 => Buffer (I) = With_Cy (I));
      pragma Assert
        (for all I in 1 .. S (4) - 2 => Buffer (I) = With_Cx (I));
      pragma Assert
        (for all I in 1 .. S (3) - 2 => Buffer (I) = With_Angle (I));
      pragma Assert
        (for all I in 1 .. S (2) - 2 => Buffer (I) = With_Id (I));
      Prove_Same_Id (With_Id, Buffer, S (1), S (2) - 2, P.Id);
      Prove_Same_Micro (With_Angle, Buffer, S (2), S (3) - 2, P.Angle);
      Prove_Same_Micro (With_Cx, Buffer, S (3), S (4) - 2, P.Cx);
      Prove_Same_Micro (With_Cy, Buffer, S (4), S (5) - 2, P.Cy);
      Prove_Same_Micro (With_Dx, Buffer, S (5), S (6) - 2, P.Dx);
      Prove_Same_Micro (With_Dy, Buffer, S (6), S (7) - 2, P.Dy);
      pragma Assert (Are_Cut (Buffer, Last - 1, S));
      pragma Assert (Are_Fields (Buffer, Last - 1, S));
      pragma Assert (Are_Fields_Of (Buffer, S, P));
      Prove_Position (Buffer, Last - 1, S, P);
   end Format_Position;

   procedure Get_Line
     (R : Line_Reader; Line : in out String; Last : out Natural)
   is
   begin
      Last := (if R.Too_Long then 0 else R.Length);
      Line (1 .. Last) := R.Data (1 .. Last);
   end Get_Line;

   procedure Judge
     (R       : Line_Reader;
      Data    : String;
      Verdict : out Beginning;
      Line    : in out String;
      Last    : out Natural)
   is
      Ahead    : Line_Reader := R;
      Complete : Boolean     := False;
      Read     : Message;
   begin
      for C of Data loop
         Accept_Character (Ahead, C, Complete);
         exit when Complete;
      end loop;
      Get_Line (Ahead, Line, Last);
      if Complete then
         Parse (Line (1 .. Last), Read);
         Verdict :=
           (if Read.Kind in Known_Kind
              or else (Last > 4 and then May_Begin (Ahead, Token_Label))
            then Known else Unknown);
      elsif May_Begin (Ahead, Token_Label)
        or else (for some K in Known_Kind => May_Begin (Ahead, Label (K)))
      then
         Verdict := Undecided;
      else
         Verdict := Unknown;
      end if;
   end Judge;

   procedure Keep (R : in out Line_Reader; C : Character) is
   begin
      if R.Length < Max_Line then
         R.Length := R.Length + 1;
         R.Data (R.Length) := C;
      else
         R.Too_Long := True;
      end if;
   end Keep;

   procedure Parse (Line : String; M : out Message) is
   begin
      M := (Malformed, 0);
      for K in Known_Kind loop
         if Is_Line_Of (Line, K) then
            M.Kind := K;
            if Takes_Number (K) then
               M.Value :=
                 Clamped_Number
                   (Line, Line'First + Text_Offset, Line'Last);
            end if;
            return;
         end if;
         pragma Loop_Invariant
           (for all J in Known_Kind'First .. K => not Is_Line_Of (Line, J));
      end loop;
   end Parse;

   procedure Parse_Position
     (Line : String; Last : Natural; P : out Position; OK : out Boolean)
   is
      S : Field_Starts;
   begin
      OK := Is_Position (Line, Last);
      if not OK then
         P := Not_Found;
         return;
      end if;
      S := Starts (Line, Last);
      pragma Assert (Is_Micro (Line, S (2), S (3) - 2));
      pragma Assert (Is_Micro (Line, S (3), S (4) - 2));
      pragma Assert (Is_Micro (Line, S (4), S (5) - 2));
      pragma Assert (Is_Micro (Line, S (5), S (6) - 2));
      pragma Assert (Is_Micro (Line, S (6), S (7) - 2));
      P := (Id    => Id_Value (Line, S (1), S (2) - 2),
            Angle => Micro (Fraction_Value (Line, S (2), S (3) - 2)),
            Cx    => Micro (Fraction_Value (Line, S (3), S (4) - 2)),
            Cy    => Micro (Fraction_Value (Line, S (4), S (5) - 2)),
            Dx    => Micro (Fraction_Value (Line, S (5), S (6) - 2)),
            Dy    => Micro (Fraction_Value (Line, S (6), S (7) - 2)));
   end Parse_Position;

   procedure Prove_Reading (Text : String) is
      R        : Line_Reader;
      Line     : String (1 .. Max_Line) := (others => ' ');
      Last     : Natural;
      Size     : Natural := 0;
      Complete : Boolean;
   begin
      for I in Text'Range loop
         Accept_Character (R, Text (I), Complete);
         pragma Assert (not Complete);
         Size := (if Text (I) = Carriage_Return then I - 1 else I);
         pragma Loop_Invariant (not Is_Complete (R));
         pragma Loop_Invariant (Is_Held (R) = (Text (I) = Carriage_Return));
         pragma Loop_Invariant
           (Size = (if Text (I) = Carriage_Return then I - 1 else I));
         pragma Loop_Invariant (Length (R) = Integer'Min (Size, Max_Line));
         pragma Loop_Invariant (Is_Too_Long (R) = (Size > Max_Line));
         pragma Loop_Invariant
           (for all J in 1 .. Length (R) => Item (R, J) = Text (J));
      end loop;
      Accept_Character (R, Line_Feed, Complete);
      pragma Assert (Complete);
      Get_Line (R, Line, Last);
      pragma Assert
        (Size = (if Text'Length > 0
                   and then Text (Text'Last) = Carriage_Return
                 then Text'Length - 1 else Text'Length));
      pragma Assert (Last = (if Size > Max_Line then 0 else Size));
      pragma Assert (for all I in 1 .. Last => Line (I) = Text (I));
   end Prove_Reading;

   procedure Prove_Field_End
     (Line : String; First : Positive; Last, Ending : Natural)
   is
      Found : constant Natural := Field_End (Line, First, Last);
   begin
      pragma Assert
        (if Found < Ending then Line (Found + 1) = Field_Separator);
      pragma Assert (Found >= Ending);
      pragma Assert
        (if Found > Ending then Line (Ending + 1) /= Field_Separator);
   end Prove_Field_End;

   procedure Prove_Position
     (Line : String; Last : Natural; S : Field_Starts; P : Position)
   is
      T : constant Field_Starts := Starts (Line, Last);
   begin
      Prove_Starts (Line, Last, S);
      pragma Assert (T (1) = S (1));
      pragma Assert (T (2) = S (2));
      pragma Assert (T (3) = S (3));
      pragma Assert (T (4) = S (4));
      pragma Assert (T (5) = S (5));
      pragma Assert (T (6) = S (6));
      pragma Assert (T (7) = S (7));
      pragma Assert (Are_Fields (Line, Last, T));
      pragma Assert (Are_Fields_Of (Line, T, P));
   end Prove_Position;

   procedure Prove_Round_Trip (P : Position) is
      Text : Position_Text;
      Last : Natural;
      Q    : Position;
      OK   : Boolean;
   begin
      Format_Position (P, Text, Last);
      Parse_Position (Text, Last - 1, Q, OK);
      pragma Assert (OK);
      pragma Assert (Q = P);
   end Prove_Round_Trip;

   procedure Prove_Same_Id
     (A, B : String; First : Positive; Last : Natural; Id : Robot_Id)
   is
      pragma Warnings (Off, Id);  --  for the contract alone
   begin
      if A (First) /= '-' then
         Numbers.Prove_Same_Value (A, B, First, Last);
      end if;
   end Prove_Same_Id;

   procedure Prove_Same_Micro
     (A, B : String; First : Positive; Last : Natural; Value : Micro)
   is
      pragma Warnings (Off, Value);  --  for the contract alone
   begin
      Numbers.Prove_Same_Value (A, B, Whole_First (A, First), Last - 7);
      Numbers.Prove_Same_Value (A, B, Last - 5, Last);
   end Prove_Same_Micro;

   procedure Prove_Starts (Line : String; Last : Natural; S : Field_Starts)
   is
      T : constant Field_Starts := Starts (Line, Last);
   begin
      pragma Assert (T (1) = S (1));
      Prove_Field_End (Line, S (1), Last, S (2) - 2);
      pragma Assert (T (2) = S (2));
      Prove_Field_End (Line, S (2), Last, S (3) - 2);
      pragma Assert (T (3) = S (3));
      Prove_Field_End (Line, S (3), Last, S (4) - 2);
      pragma Assert (T (4) = S (4));
      Prove_Field_End (Line, S (4), Last, S (5) - 2);
      pragma Assert (T (5) = S (5));
      Prove_Field_End (Line, S (5), Last, S (6) - 2);
      pragma Assert (T (6) = S (6));
      Prove_Field_End (Line, S (6), Last, S (7) - 2);
      pragma Assert (T (7) = S (7));
   end Prove_Starts;

   procedure Put_Field
     (Value  : Micro;
      Buffer : in out Position_Text;
      Last   : in out Natural)
   is
   begin
      Last := Last + 1;
      Buffer (Last) := Field_Separator;
      Put_Micro (Value, Buffer, Last);
   end Put_Field;

   procedure Put_Id
     (Id     : Robot_Id;
      Buffer : in out Position_Text;
      Last   : in out Natural)
   is
   begin
      if Id < 0 then
         Buffer (Last + 1) := '-';
         Buffer (Last + 2) := '1';
         Last := Last + 2;
      else
         Numbers.Append (Id, 1, Buffer, Last);
      end if;
   end Put_Id;

   procedure Put_Micro
     (Value  : Micro;
      Buffer : in out Position_Text;
      Last   : in out Natural)
   is
      Size   : constant Micro := abs Value;
      First  : constant Positive := Last + 1 with Ghost;
      Before : Position_Text with Ghost;
   begin
      if Value < 0 then
         Last := Last + 1;
         Buffer (Last) := '-';
      end if;
      Numbers.Append (Numbers.Number (Size / 1_000_000), 1, Buffer, Last);
      Before := Buffer;
      Last := Last + 1;
      Buffer (Last) := '.';
      Numbers.Append (Numbers.Number (Size mod 1_000_000), 6, Buffer, Last);
      Numbers.Prove_Same_Value
        (Before, Buffer, Whole_First (Buffer, First), Last - 7);
      pragma Assert (Is_Fraction (Buffer, First, Last));
      pragma Assert (Fraction_Value (Buffer, First, Last) = Wide (Value));
   end Put_Micro;

   function Short (Text : String) return Short_Text is
      Result : Short_Text;
   begin
      Result.Data (1 .. Text'Last) := Text;
      Result.Data (Text'Last + 1) := Line_Feed;
      Result.Length := Text'Last + 1;
      return Result;
   end Short;

   function Starts (Line : String; Last : Natural) return Field_Starts is
      Result : Field_Starts := (1 => First_Field, others => Last + 3);
   begin
      for I in 1 .. 6 loop
         exit when Result (I) > Last + 1;
         Result (I + 1) := Field_End (Line, Result (I), Last) + 2;
         pragma Loop_Invariant (Result (1) = First_Field);
         pragma Loop_Invariant
           (for all J in 1 .. I =>
              Result (J) <= Last + 1
              and then Result (J + 1) =
                         Field_End (Line, Result (J), Last) + 2);
         pragma Loop_Invariant
           (for all J in I + 2 .. 7 => Result (J) = Last + 3);
      end loop;
      return Result;
   end Starts;

end Monitor.Protocol;
