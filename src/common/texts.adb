--  SPDX-License-Identifier: GPL-3.0-or-later

package body Texts with SPARK_Mode is

   procedure Append (T : in out Text; Value : String) is
      Start : constant Natural := T.Length;
      Count : constant Natural :=
        Natural'Min (Value'Length, Max_Length - Start);
   begin
      for I in 1 .. Count loop
         T.Data (Start + I) := Value (Value'First + (I - 1));
         pragma Loop_Invariant
           (for all J in T.Data'Range =>
              T.Data (J) =
                (if J in Start + 1 .. Start + I
                 then Value (Value'First + (J - Start - 1))
                 else T'Loop_Entry.Data (J)));
      end loop;
      T.Length := Start + Count;
   end Append;

   procedure Append
     (T : in out Text; Value : Integer; Width : Positive := 1)
   is
      subtype Digit_Place is Integer range 1 .. 10;
      Digit : String (Digit_Place) := (others => '0');
      First : Digit_Place;
      Rest  : Integer := (if Value < 0 then Value else -Value);
      --  negative: the negative range is larger
   begin
      for Place in reverse Digit_Place loop
         Digit (Place) := Character'Val (Character'Pos ('0') - Rest rem 10);
         First := Place;
         Rest := Rest / 10;
         exit when Rest = 0 and then Place <= 11 - Width;
         pragma Loop_Invariant (Rest <= 0);
      end loop;
      if Value < 0 then
         Append (T, "-");
      end if;
      Append (T, Digit (First .. Digit_Place'Last));
   end Append;

   procedure Set (T : out Text; Value : String) is
   begin
      T := (others => <>);
      Append (T, Value);
   end Set;

   function To_Text (Value : String) return Text is
      Result : Text;
   begin
      Append (Result, Value);
      return Result;
   end To_Text;

end Texts;
