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

   Max_Text : constant := Max_Line - 2;

   function Padded (R : Reader; I : Positive) return Character is
     (if I <= Text_Length (R) then R.Data (I) else ' ')
   with Pre => I <= Max_Text;
   --  Character I of the line, blanks after its end

   function Wanted (T : Token; I : Positive) return Character is
     (if I <= Label'Length then Label (I) else T.Data (I - Label'Length))
   with Pre => I <= Max_Text;
   --  The same of the right one

   function Is_Same (R : Reader; T : Token) return Boolean
   with
     Post => Is_Same'Result =
       (Text_Length (R) = Label'Length + T.Length
        and then (for all I in 1 .. Max_Text => Padded (R, I) = Wanted (T, I)))
   is
      --  Compares all places in any case: its time depends only on the length
      --  of the line
      Difference : Unsigned_32 :=
        Added (0, Unsigned_32 (Text_Length (R)),
               Unsigned_32 (Label'Length + T.Length));
   begin
      for I in 1 .. Max_Text loop
         Difference :=
           Added (Difference, Code (Padded (R, I)), Code (Wanted (T, I)));
         pragma Loop_Invariant
           ((Difference = 0) =
              (Text_Length (R) = Label'Length + T.Length
               and then (for all J in 1 .. I =>
                           Padded (R, J) = Wanted (T, J))));
      end loop;
      return Difference = 0;
   end Is_Same;

   function Decision (R : Reader; T : Token) return Verdict is
     (if R.Length > 0 and then R.Data (R.Length) = Line_Feed then
        (if Is_Same (R, T) then Right else Wrong)
      elsif R.Length = Max_Line then Wrong
      else Undecided);

   procedure Append_Shown (To : in out Texts.Text; Line : String) is
      Last : constant Natural := Line'First - 1 + Shown_Length (Line);
   begin
      Texts.Append (To, Line (Line'First .. Last));
      if Last in Line'Range and then Is_Label_End (Line, Last) then
         Texts.Append (To, "...");
      end if;
   end Append_Shown;

   procedure Read_Token (Text : String; T : out Token; Good : out Boolean) is
      Data : String (1 .. Max_Token) := (others => ' ');
      Last : Natural := 0;
   begin
      T := (others => <>);
      for I in Text'Range loop
         exit when Text (I) not in Token_Character or else I > Max_Token;
         Data (I) := Text (I);
         Last := I;
         pragma Loop_Invariant (Last = I);
         pragma Loop_Invariant
           (for all J in Data'Range =>
              (if J <= I then Data (J) = Text (J)
                              and then Data (J) in Token_Character
               else Data (J) = ' '));
      end loop;
      Good := Last in Min_Token .. Max_Token
        and then (Last = Text'Last or else Text (Last + 1) = Line_Feed);
      if Good then
         T := (Data => Data, Length => Last);
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
