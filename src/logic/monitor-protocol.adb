--  SPDX-License-Identifier: GPL-3.0-or-later

package body Monitor.Protocol with SPARK_Mode is

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

   function Short (Text : String) return Short_Text is
      Result : Short_Text;
   begin
      Result.Data (1 .. Text'Last) := Text;
      Result.Data (Text'Last + 1) := Line_Feed;
      Result.Length := Text'Last + 1;
      return Result;
   end Short;

end Monitor.Protocol;
