--  SPDX-License-Identifier: GPL-3.0-or-later

package body Admission.Authentication with SPARK_Mode is

   use Interfaces;

   function Code (C : Character) return Unsigned_32 is
     (Unsigned_32 (Character'Pos (C)));

   function Added (Difference, X, Y : Unsigned_32) return Unsigned_32 is
     (Difference or (X xor Y))
   with
     Post => (Added'Result = 0) = (Difference = 0 and then X = Y);
   --  Accumulates differences: 0 as long as there is none

   function Text_Length (R : Reader) return Line_Count is
     (if R.Length >= 2 and then R.Data (R.Length - 1) = Carriage_Return
      then R.Length - 2
      else R.Length - 1)
   with Pre => R.Length > 0;
   --  The length of the line without its end

   function Padded (R : Reader; I : Positive) return Character is
     (if I <= Text_Length (R) then R.Data (I) else ' ')
   with Pre => R.Length > 0 and then I <= Max_Line;
   --  Character I of the line, blanks after its end

   function Is_Same (R : Reader; T : Token) return Boolean
   with
     Pre  => R.Length > 0,
     Post => Is_Same'Result =
       (Text_Length (R) = Label'Length + T.Length
        and then (for all I in Label'Range => Padded (R, I) = Label (I))
        and then (for all I in 1 .. Max_Token =>
                    Padded (R, Label'Length + I) = T.Data (I)));
   --  The line is the label and the token. Compares all places in any case:
   --  its time depends only on the length of the line

   procedure Accept_Character
     (R : in out Reader; T : Token; C : Character) is
   begin
      R.Length := R.Length + 1;
      R.Data (R.Length) := C;
      if C = Line_Feed then
         R.State := (if Is_Same (R, T) then Right else Wrong);
      elsif R.Length = Max_Line then
         R.State := Wrong;
      end if;
   end Accept_Character;

   procedure Append_Shown (To : in out Texts.Text; Line : String) is
      Last : constant Natural := Line'First - 1 + Shown_Length (Line);
   begin
      Texts.Append (To, Line (Line'First .. Last));
      if Last in Line'Range and then Is_Label_End (Line, Last) then
         Texts.Append (To, "...");
      end if;
   end Append_Shown;

   procedure Clear (R : out Reader) is
   begin
      R := (others => <>);
   end Clear;

   function Is_Same (R : Reader; T : Token) return Boolean is
      Difference : Unsigned_32 :=
        Added (0, Unsigned_32 (Text_Length (R)),
               Unsigned_32 (Label'Length + T.Length));
   begin
      for I in Label'Range loop
         Difference := Added (Difference, Code (Padded (R, I)),
                              Code (Label (I)));
         pragma Loop_Invariant
           ((Difference = 0) =
              (Text_Length (R) = Label'Length + T.Length
               and then (for all J in 1 .. I => Padded (R, J) = Label (J))));
      end loop;
      for I in T.Data'Range loop
         Difference := Added (Difference, Code (Padded (R, Label'Length + I)),
                              Code (T.Data (I)));
         pragma Loop_Invariant
           ((Difference = 0) =
              (Text_Length (R) = Label'Length + T.Length
               and then (for all J in Label'Range =>
                           Padded (R, J) = Label (J))
               and then (for all J in 1 .. I =>
                           Padded (R, Label'Length + J) = T.Data (J))));
      end loop;
      return Difference = 0;
   end Is_Same;

   function Line_Length (Text : String) return Natural is
   begin
      for I in Text'Range loop
         if Text (I) = Line_Feed then
            return I - 1;
         end if;
         pragma Loop_Invariant
           (for all J in 1 .. I => Text (J) /= Line_Feed);
      end loop;
      return Text'Length;
   end Line_Length;

   procedure Read_Token (Text : String; T : out Token; Good : out Boolean) is
      Data : String (1 .. Max_Token) := (others => ' ');
   begin
      T := (others => <>);
      Good := Begins_With_Token (Text);
      if Good then
         for I in 1 .. Line_Length (Text) loop
            Data (I) := Text (I);
            pragma Loop_Invariant
              (for all J in Data'Range =>
                 Data (J) = (if J <= I then Text (J) else ' '));
         end loop;
         T := (Data => Data, Length => Line_Length (Text));
      end if;
   end Read_Token;

   function Shown_Length (Line : String) return Natural is
   begin
      for I in Line'Range loop
         if Is_Label_End (Line, I) then
            return I - Line'First + 1;
         end if;
         pragma Loop_Invariant
           (for all J in Line'First .. I => not Is_Label_End (Line, J));
      end loop;
      return Line'Length;
   end Shown_Length;

end Admission.Authentication;
