--  SPDX-License-Identifier: GPL-3.0-or-later
--  Texts of bounded length, for what crosses from one task to another: no
--  allocation, no secondary stack.

package body Texts with SPARK_Mode is

   ------------
   -- Append --
   ------------

   procedure Append (T : in out Text; Value : String) is
   begin
      for C of Value loop
         exit when T.Length = Max_Length;
         T.Length := T.Length + 1;
         T.Data (T.Length) := C;
      end loop;
   end Append;

   procedure Append (T : in out Text; Value : Integer) is
      subtype Digit_Place is Integer range 1 .. 10;
      Digit : String (Digit_Place) := (others => '0');
      First : Digit_Place;
      Rest  : Integer := (if Value < 0 then Value else -Value);
      --  negative: its range is the larger one
   begin
      for Place in reverse Digit_Place loop
         Digit (Place) := Character'Val (Character'Pos ('0') - Rest rem 10);
         First := Place;
         Rest := Rest / 10;
         exit when Rest = 0;
      end loop;
      if Value < 0 then
         Append (T, "-");
      end if;
      Append (T, Digit (First .. Digit_Place'Last));
   end Append;

   ---------
   -- Set --
   ---------

   procedure Set (T : out Text; Value : String) is
   begin
      T := (others => <>);
      Append (T, Value);
   end Set;

   -------------
   -- To_Text --
   -------------

   function To_Text (Value : String) return Text is
      Result : Text;
   begin
      for C of Value loop
         exit when Result.Length = Max_Length;
         Result.Length := Result.Length + 1;
         Result.Data (Result.Length) := C;
      end loop;
      return Result;
   end To_Text;

end Texts;
