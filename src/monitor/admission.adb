--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Characters.Handling;
with Ada.Strings.Fixed;

package body Admission with SPARK_Mode is

   procedure Read_Token (Text : String; T : out Token) is
      Last : Natural := 0;
   begin
      for I in Text'Range loop
         exit when Text (I) not in Token_Character or else I > Max_Token;
         Last := I;
         pragma Loop_Invariant
           (Last = I
            and then (for all J in 1 .. I => Text (J) in Token_Character));
      end loop;
      T := (others => <>);
      if Last in Min_Token .. Max_Token
        and then (Last = Text'Last or else Text (Last + 1) = ASCII.LF)
      then
         T := (Text (1 .. Last) & (1 .. Max_Token - Last => ' '), Last);
      end if;
   end Read_Token;

   function Decision (R : Reader; T : Token) return Verdict is
      --  Compares all places in any case
      Length : constant Line_Count := Text_Length (R);
      Same   : Boolean := Length = Label'Length + T.Length;
   begin
      if R.Length = 0 or else R.Data (R.Length) /= ASCII.LF then
         return (if R.Length = Max_Line then Wrong else Undecided);
      end if;
      for I in 1 .. Max_Line - 2 loop
         Same := Same
           and ((if I <= Length then R.Data (I) else ' ') = Expected (T, I));
         pragma Loop_Invariant
           (Same = (Length = Label'Length + T.Length
                    and then (for all J in 1 .. Natural'Min (I, Length) =>
                                R.Data (J) = Expected (T, J))));
      end loop;
      return (if Same then Right else Wrong);
   end Decision;

   procedure Append_Shown (To : in out Texts.Text; Line : String) is
      Place : constant Natural := Ada.Strings.Fixed.Index
        (Ada.Characters.Handling.To_Upper (Line), Label);
      --  also of a label in small letters, as somebody types it
   begin
      Texts.Append
        (To, (if Place = 0 then Line
              else Line (Line'First
                         .. Line'First + (Place - 1) + (Label'Length - 1))));
      Texts.Append (To, (if Place = 0 then "" else "..."));
   end Append_Shown;

end Admission;
