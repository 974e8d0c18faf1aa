--  SPDX-License-Identifier: GPL-3.0-or-later

package body Monitor.Protocol with SPARK_Mode is

   function Telnet_End
     (Line : String; First : Positive; Last : Natural) return Natural
   with
     Pre  => Line'Last < Integer'Last
       and then First >= Line'First
       and then Last <= Line'Last
       and then First <= Last + 1,
     Post => Telnet_End'Result in First - 1 .. Last
       and then (if First > Last or else Line (First) /= Telnet_Mark
                 then Telnet_End'Result = First - 1)
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

   procedure Keep (R : in out Line_Reader; C : Character)
   with
     Post => R.Held = R'Old.Held
       and then R.Finished = R'Old.Finished
       and then R.Length = Integer'Min (R'Old.Length + 1, Max_Line)
       and then R.Too_Long =
                  (R'Old.Too_Long or else R'Old.Length = Max_Line)
       and then (for all I in 1 .. R'Old.Length =>
                   R.Data (I) = R'Old.Data (I))
       and then (if R'Old.Length < Max_Line then R.Data (R.Length) = C)
   is
      --  Appends C to the line if there is room; otherwise it is too long
   begin
      if R.Length < Max_Line then
         R.Length := R.Length + 1;
         R.Data (R.Length) := C;
      else
         R.Too_Long := True;
      end if;
   end Keep;

   function After_Telnet
     (Line : String; First : Positive; Last : Natural) return Positive
   is
      Place : Positive := First;
      Ended : Natural;
   begin
      loop
         pragma Loop_Invariant (Place in First .. Last + 1);
         pragma Loop_Invariant
           (if First > Last or else Line (First) /= Telnet_Mark
            then Place = First);
         pragma Loop_Variant (Increases => Place);
         Ended := Telnet_End (Line, Place, Last);
         exit when Ended < Place;
         Place := Ended + 1;
      end loop;
      return Place;
   end After_Telnet;

   procedure Accept_Character
     (R : in out Line_Reader; C : Character; Complete : out Boolean)
   is
   begin
      if R.Finished then
         R := (others => <>);
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

   procedure Get_Line
     (R : Line_Reader; Line : in out String; Last : out Natural)
   is
   begin
      Last := 0;
      if not R.Too_Long then
         Last := Text_Last (R) - Text_First (R) + 1;
         Line (1 .. Last) := R.Data (Text_First (R) .. Text_Last (R));
      end if;
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
      Read     : Command;
   begin
      for C of Data loop
         Accept_Character (Ahead, C, Complete);
         exit when Complete;
      end loop;
      Get_Line (Ahead, Line, Last);
      if Complete then
         Parse (Line (1 .. Last), Read);
         Verdict :=
           (if Read.Name in Known_Command
              or else (Last > 4 and then May_Begin (Ahead, Token_Label))
            then Known else Unknown);
      elsif (Text_First (Ahead) <= Ahead.Length
             and then Ahead.Data (Text_First (Ahead)) = Telnet_Mark)
        or else May_Begin (Ahead, Token_Label)
        or else (for some N in Known_Command =>
                    May_Begin (Ahead, Table (N).Label))
      then
         Verdict := Undecided;
      else
         Verdict := Unknown;
      end if;
   end Judge;

   procedure Parse (Line : String; C : out Command) is
   begin
      C := (Malformed, 0);
      for N in Known_Command loop
         if Is_Line_Of (Line, N) then
            C.Name := N;
            if Takes_Number (N) then
               C.Value :=
                 Clamped_Number
                   (Line, Line'First + Text_Offset, Line'Last);
            end if;
            return;
         end if;
         pragma Loop_Invariant
           (for all J in Known_Command'First .. N =>
              not Is_Line_Of (Line, J));
      end loop;
   end Parse;

   function Text_First (R : Line_Reader) return Positive is
     (After_Telnet (R.Data, 1, R.Length));

   function Text_Last (R : Line_Reader) return Line_Length is
   begin
      for I in Text_First (R) .. R.Length loop
         if R.Data (I) = Telnet_Mark then
            return
              (if After_Telnet (R.Data, I, R.Length) > R.Length then I - 1
               else R.Length);
         end if;
      end loop;
      return R.Length;
   end Text_Last;

end Monitor.Protocol;
