--  SPDX-License-Identifier: GPL-3.0-or-later
--  The wire format of the monitor: its lines become messages, answers and
--  positions become lines.

package body Monitor_Protocol with SPARK_Mode is

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

   subtype Number_Field is Integer range 2 .. 6;

   function Field (P : Position; I : Number_Field) return Micro is
     (case I is
         when 2 => P.Angle,
         when 3 => P.Cx,
         when 4 => P.Cy,
         when 5 => P.Dx,
         when 6 => P.Dy);
   --  The number in field I of P's line.

   function Are_First_Fields
     (Line : String; S : Field_Starts; P : Position; Count : Positive)
     return Boolean
   is (S (1) = First_Field
       and then S (Count + 1) <= Line'Last + 2
       and then (for all I in 1 .. Count => S (I) < S (I + 1))
       and then (for all I in 2 .. Count =>
                   Line (S (I) - 1) = Field_Separator)
       and then (for all I in 1 .. Count =>
                   (for all J in S (I) .. S (I + 1) - 2 =>
                      Line (J) not in Field_Separator | Line_Feed))
       and then Reads_As_Id (Line, S (1), S (2) - 2, P.Id)
       and then (for all I in 2 .. Count =>
                   Reads_As_Micro
                     (Line, S (I), S (I + 1) - 2, Field (P, I))))
   with
     Ghost,
     Pre => Line'First = 1
       and then Line'Last <= Max_Position
       and then Count <= 6
       and then (for all I in Field_Starts'Range =>
                   S (I) in First_Field .. Line'Last + 2)
       and then (for all I in 1 .. Count => S (I) < S (I + 1));
   --  The first Count fields of Line are those of P, and begin at S.

   procedure Prove_Same_Fields
     (A, B  : String;
      S     : Field_Starts;
      P     : Position;
      Count : Positive)
   with
     Ghost,
     Pre  => A'First = 1
       and then B'First = 1
       and then A'Last <= Max_Position
       and then B'Last = A'Last
       and then Count <= 6
       and then (for all I in Field_Starts'Range =>
                   S (I) in First_Field .. A'Last + 2)
       and then (for all I in 1 .. Count => S (I) < S (I + 1))
       and then Are_First_Fields (A, S, P, Count)
       and then (for all I in 1 .. S (Count + 1) - 2 => A (I) = B (I)),
     Post => Are_First_Fields (B, S, P, Count);

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
   --  A number depends on its own characters alone.

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

   procedure Prove_Starts (Line : String; Last : Natural; S : Field_Starts)
   with
     Ghost,
     Pre  => Line'First = 1
       and then Line'Last <= Max_Position
       and then Last in First_Field .. Line'Last
       and then S (1) = First_Field
       and then S (7) = Last + 2
       and then (for all I in 1 .. 6 => S (I) < S (I + 1))
       and then (for all I in 1 .. 6 =>
                   (for all J in S (I) .. S (I + 1) - 2 =>
                      Line (J) /= Field_Separator))
       and then (for all I in 2 .. 6 => Line (S (I) - 1) = Field_Separator),
     Post => Starts (Line, Last) = S;
   --  Fields are where their separators say.

   procedure Keep (R : in out Line_Reader; C : Character);
   --  Appends C to the line where there is room, and notes where not.

   function Short (Text : String) return Short_Text
   with
     Pre  => Text'First = 1 and then Text'Last in 4 .. 7,
     Post => Short'Result.Length = Text'Last + 1
       and then (for all I in Text'Range =>
                   Short'Result.Data (I) = Text (I))
       and then Short'Result.Data (Text'Last + 1) = Line_Feed;
   --  Text and a line feed.

   ----------------------
   -- Accept_Character --
   ----------------------

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

   -----------
   -- Clear --
   -----------

   procedure Clear (R : out Line_Reader) is
   begin
      R := (Data     => (others => ' '),
            Length   => 0,
            Held     => False,
            Too_Long => False,
            Finished => False);
   end Clear;

   ---------------
   -- Field_End --
   ---------------

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

   ---------------------
   -- Format_Position --
   ---------------------

   procedure Format_Position
     (P      : Position;
      Buffer : out Position_Text;
      Last   : out Natural)
   is
      S      : Field_Starts := (others => First_Field) with Ghost;
      Before : Position_Text with Ghost;
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
      for I in Number_Field loop
         pragma Loop_Invariant (Last in 6 .. 8 + 17 * (I - 2));
         pragma Loop_Invariant (Last >= 6 + 9 * (I - 2));
         pragma Loop_Invariant
           (for all J in Field_Starts'Range =>
              S (J) in First_Field .. Max_Position);
         pragma Loop_Invariant (for all J in 1 .. I - 1 => S (J) < S (J + 1));
         pragma Loop_Invariant (S (I) = Last + 2);
         pragma Loop_Invariant (Begins_With (Buffer, Position_Label));
         pragma Loop_Invariant (Has_Data (Buffer));
         pragma Loop_Invariant (Are_First_Fields (Buffer, S, P, I - 1));
         Before := Buffer;
         Last := Last + 1;
         Buffer (Last) := Field_Separator;
         Put_Micro (Field (P, I), Buffer, Last);
         Prove_Same_Fields (Before, Buffer, S, P, I - 1);
         S (I + 1) := Last + 2;
      end loop;
      Before := Buffer;
      Last := Last + 1;
      Buffer (Last) := Line_Feed;
      Prove_Same_Fields (Before, Buffer, S, P, 6);
      Prove_Starts (Buffer, Last - 1, S);
   end Format_Position;

   --------------
   -- Get_Line --
   --------------

   procedure Get_Line
     (R : Line_Reader; Line : in out String; Last : out Natural)
   is
   begin
      Last := (if R.Too_Long then 0 else R.Length);
      Line (1 .. Last) := R.Data (1 .. Last);
   end Get_Line;

   ----------
   -- Keep --
   ----------

   procedure Keep (R : in out Line_Reader; C : Character) is
   begin
      if R.Length < Max_Line then
         R.Length := R.Length + 1;
         R.Data (R.Length) := C;
      else
         R.Too_Long := True;
      end if;
   end Keep;

   -----------
   -- Parse --
   -----------

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

   --------------------
   -- Parse_Position --
   --------------------

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
      P := (Id    => Id_Value (Line, S (1), S (2) - 2),
            Angle => Micro (Fraction_Value (Line, S (2), S (3) - 2)),
            Cx    => Micro (Fraction_Value (Line, S (3), S (4) - 2)),
            Cy    => Micro (Fraction_Value (Line, S (4), S (5) - 2)),
            Dx    => Micro (Fraction_Value (Line, S (5), S (6) - 2)),
            Dy    => Micro (Fraction_Value (Line, S (6), S (7) - 2)));
   end Parse_Position;

   ----------------------
   -- Prove_Round_Trip --
   ----------------------

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

   -----------------------
   -- Prove_Same_Fields --
   -----------------------

   procedure Prove_Same_Fields
     (A, B  : String;
      S     : Field_Starts;
      P     : Position;
      Count : Positive)
   is
   begin
      Prove_Same_Id (A, B, S (1), S (2) - 2, P.Id);
      for I in 2 .. Count loop
         Prove_Same_Micro (A, B, S (I), S (I + 1) - 2, Field (P, I));
         pragma Loop_Invariant
           (for all J in 2 .. I =>
              Reads_As_Micro (B, S (J), S (J + 1) - 2, Field (P, J)));
      end loop;
   end Prove_Same_Fields;

   -------------------
   -- Prove_Same_Id --
   -------------------

   procedure Prove_Same_Id
     (A, B : String; First : Positive; Last : Natural; Id : Robot_Id)
   is
      pragma Unreferenced (Id);
   begin
      if A (First) /= '-' then
         Numbers.Prove_Same_Value (A, B, First, Last);
      end if;
   end Prove_Same_Id;

   ----------------------
   -- Prove_Same_Micro --
   ----------------------

   procedure Prove_Same_Micro
     (A, B : String; First : Positive; Last : Natural; Value : Micro)
   is
      pragma Unreferenced (Value);
   begin
      Numbers.Prove_Same_Value (A, B, Whole_First (A, First), Last - 7);
      Numbers.Prove_Same_Value (A, B, Last - 5, Last);
   end Prove_Same_Micro;

   ------------------
   -- Prove_Starts --
   ------------------

   procedure Prove_Starts (Line : String; Last : Natural; S : Field_Starts)
   is
      T : constant Field_Starts := Starts (Line, Last);
   begin
      for I in 1 .. 6 loop
         pragma Loop_Invariant (for all J in 1 .. I => T (J) = S (J));
         pragma Assert (Field_End (Line, T (I), Last) = S (I + 1) - 2);
      end loop;
   end Prove_Starts;

   ------------
   -- Put_Id --
   ------------

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

   ---------------
   -- Put_Micro --
   ---------------

   procedure Put_Micro
     (Value  : Micro;
      Buffer : in out Position_Text;
      Last   : in out Natural)
   is
      Size : constant Micro := abs Value;
   begin
      if Value < 0 then
         Last := Last + 1;
         Buffer (Last) := '-';
      end if;
      Numbers.Append (Numbers.Number (Size / 1_000_000), 1, Buffer, Last);
      Last := Last + 1;
      Buffer (Last) := '.';
      Numbers.Append (Numbers.Number (Size mod 1_000_000), 6, Buffer, Last);
   end Put_Micro;

   -----------
   -- Short --
   -----------

   function Short (Text : String) return Short_Text is
      Result : Short_Text;
   begin
      Result.Data (1 .. Text'Last) := Text;
      Result.Data (Text'Last + 1) := Line_Feed;
      Result.Length := Text'Last + 1;
      return Result;
   end Short;

   ------------
   -- Starts --
   ------------

   function Starts (Line : String; Last : Natural) return Field_Starts is
      Result : Field_Starts := (1 => First_Field, others => Last + 3);
   begin
      for I in 1 .. 6 loop
         exit when Result (I) > Last + 1;
         Result (I + 1) := Field_End (Line, Result (I), Last) + 2;
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

   ---------------
   -- Wire_Text --
   ---------------

   function Wire_Text (Answer : Answer_Kind) return Short_Text is
     (case Answer is
         when Acknowledged    => Short ("AACK"),
         when Not_Done        => Short ("ANAK"),
         when Refused         => Short ("ACRJ"),
         when Timed_Out       => Short ("ATIM"),
         when Not_Understood  => Short ("ACER"),
         when Battery_Empty   => Short ("RBLV:0"),
         when Battery_Low     => Short ("RBLV:1"),
         when Battery_Full    => Short ("RBLV:2"),
         when Battery_Unknown => Short ("RBLV:-1"),
         when Standing        => Short ("RCST:0"),
         when Moving          => Short ("RCST:1"));

end Monitor_Protocol;
