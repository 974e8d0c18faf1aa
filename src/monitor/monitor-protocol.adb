--  SPDX-License-Identifier: GPL-3.0-or-later

package body Monitor.Protocol with SPARK_Mode is

   function Place_Of
     (Mark : Character; Line : String; First : Positive; Last : Natural)
      return Positive is
   begin
      for I in First .. Last loop
         if Line (I) = Mark then
            return I;
         end if;
         pragma Loop_Invariant (for all J in First .. I => Line (J) /= Mark);
      end loop;
      return Last + 1;
   end Place_Of;

   procedure Parse (Line : String; C : out Command) is
   begin
      C := (Malformed, 0);
      for N in Known_Command loop
         if Is_Line_Of (Line, N) then
            C.Name := N;
            if Takes_Number (N) then
               C.Value := Clamped_Number (Line, Line'First + Text_Offset);
            end if;
            return;
         end if;
         pragma Loop_Invariant
           (for all J in Known_Command'First .. N =>
              not Is_Line_Of (Line, J));
      end loop;
   end Parse;

   procedure Parse
     (Line    : String;
      First   : Positive;
      Measure : Unit;
      Most    : Point_Number;
      P       : out Path;
      Valid   : out Boolean)
   is
      Next   : Positive := First;
      Second : Positive;
   begin
      P := (Measure => Measure, others => <>);
      Valid := Is_Path (Line, First, Most);
      if Valid then
         loop
            Second := Field_End (Line, Next) + 2;
            P.Count := P.Count + 1;
            P.Points (P.Count) :=
              (X => Coordinate_Value (Line, Next, Second - 2),
               Y => Coordinate_Value (Line, Second, Field_End (Line, Second)));
            exit when Field_End (Line, Second) = Line'Last;
            Next := Field_End (Line, Second) + 2;
            pragma Loop_Invariant (Is_Slice (Line, Next, Line'Last));
            pragma Loop_Invariant (P.Measure = Measure);
            pragma Loop_Invariant (P.Count in 1 .. Most - 1);
            pragma Loop_Invariant
              (Are_Points (Line, Next, 2 * (Most - P.Count)));
            pragma Loop_Variant (Increases => P.Count);
         end loop;
      end if;
   end Parse;

   function Telnet_End
     (Line : String; First : Positive; Last : Natural) return Natural
   with
     Pre  => Is_Slice (Line, First, Last),
     Post => Telnet_End'Result in First - 1 .. Last
   is
      --  The end of the telnet command at First; First - 1 if there is none.
      Place : Positive;
   begin
      if First >= Last or else Line (First) /= Telnet_Mark then
         return First - 1;
      end if;
      case Character'Pos (Line (First + 1)) is
         when 236 .. 249 | 255 =>
            return First + 1;
         when 251 .. 254 =>  --  and an option
            return (if First + 2 <= Last then First + 2 else First - 1);
         when 250 =>  --  and all up to the mark and 240
            Place := First + 2;
            while Place < Last loop
               pragma Loop_Invariant (Place >= First + 2);
               pragma Loop_Variant (Increases => Place);
               if Line (Place) /= Telnet_Mark then
                  Place := Place + 1;
               elsif Character'Pos (Line (Place + 1)) = 240 then
                  return Place + 1;
               else
                  Place := Place + 2;
               end if;
            end loop;
            return First - 1;
         when others =>
            return First - 1;
      end case;
   end Telnet_End;

   function After_Telnet
     (Line : String; First : Positive; Last : Natural) return Positive
   with
     Pre  => Is_Slice (Line, First, Last),
     Post => After_Telnet'Result in First .. Last + 1
   is
      --  Where what follows the telnet commands at First begins. One that has
      --  not been received as a whole is none
      Place : Positive := First;
      Ended : Natural;
   begin
      loop
         pragma Loop_Invariant (Place in First .. Last + 1);
         pragma Loop_Variant (Increases => Place);
         Ended := Telnet_End (Line, Place, Last);
         exit when Ended < Place;
         Place := Ended + 1;
      end loop;
      return Place;
   end After_Telnet;

   function Received (R : Line_Reader) return Natural is
     (if R.Length > 0 and then R.Data (R.Length) = Carriage_Return
      then R.Length - 1 else R.Length);
   --  Characters of the line so far, without a carriage return at its end

   function Text_First (R : Line_Reader) return Positive is
     (After_Telnet (R.Data, 1, Received (R)));

   function Text_Last (R : Line_Reader) return Natural
   with Post => Text_Last'Result in Text_First (R) - 1 .. Received (R)
   is
      --  The last character before the telnet commands at the line's end
   begin
      for I in Text_First (R) .. Received (R) loop
         if R.Data (I) = Telnet_Mark then
            return
              (if After_Telnet (R.Data, I, Received (R)) > Received (R)
               then I - 1 else Received (R));
         end if;
      end loop;
      return Received (R);
   end Text_Last;

   function May_Begin (R : Line_Reader; Start : Label_Text) return Boolean is
     ((for all I in 1 .. Integer'Min (Received (R) - Text_First (R) + 1, 4) =>
         R.Data (Text_First (R) + I - 1) = Start (I))
      and then
        (Received (R) < Text_First (R) + 4
         or else R.Data (Text_First (R) + 4) in Separator | Telnet_Mark));
   --  The line so far is the beginning of Start and a separator, or begins
   --  with them, without telnet commands

   procedure Accept_Character
     (R : in out Line_Reader; C : Character; Complete : out Boolean) is
   begin
      Complete := C = Line_Feed;
      if Complete then
         null;
      elsif R.Length < R.Data'Last then
         R.Length := R.Length + 1;
         R.Data (R.Length) := C;
      else
         R.Too_Long := True;
      end if;
   end Accept_Character;

   procedure Get_Line
     (R : Line_Reader; Line : in out Line_Buffer; Last : out Line_Length) is
   begin
      Last := 0;
      if not R.Too_Long and then Received (R) <= Max_Line then
         Last := Text_Last (R) - Text_First (R) + 1;
         Line (1 .. Last) := R.Data (Text_First (R) .. Text_Last (R));
      end if;
   end Get_Line;

   procedure Judge
     (R       : Line_Reader;
      Data    : String;
      Verdict : out Beginning;
      Line    : in out Line_Buffer;
      Last    : out Line_Length)
   is
      Ahead    : Line_Reader := R;
      Complete : Boolean     := False;
      Token    : Boolean;
      Read     : Command;
   begin
      for C of Data loop
         Accept_Character (Ahead, C, Complete);
         exit when Complete;
      end loop;
      Token := May_Begin (Ahead, Token_Label);
      Get_Line (Ahead, Line, Last);
      if Complete then
         Parse (Line (1 .. Last), Read);
         Verdict :=
           (if Read.Name in Known_Command or else (Last > 4 and then Token)
            then Known else Unknown);
      elsif Token
        or else (Text_First (Ahead) <= Received (Ahead)
                 and then Ahead.Data (Text_First (Ahead)) = Telnet_Mark)
        or else (for some N in Known_Command =>
                    May_Begin (Ahead, Table (N).Label))
      then
         Verdict := Undecided;
      else
         Verdict := Unknown;
      end if;
   end Judge;

   procedure Append (Line : in out Short_Text; Text : String) is
   begin
      Line.Data (Line.Length + 1 .. Line.Length + Text'Length) := Text;
      Line.Length := Line.Length + Text'Length;
   end Append;

end Monitor.Protocol;
