--  SPDX-License-Identifier: GPL-3.0-or-later

package body Lock_Tables with SPARK_Mode is

   procedure Append_Hexadecimal
     (To : in out Texts.Text; Number : Interfaces.Unsigned_32)
   is
      --  Two digits or more
      All_Digits : constant String := "0123456789abcdef";
      Left       : Interfaces.Unsigned_32;
      Digit      : Positive range 1 .. 16;
   begin
      for Place in reverse 0 .. 7 loop
         Left := Interfaces.Shift_Right (Number, 4 * Place);
         Digit := Natural (Left mod 16) + 1;
         if Left > 0 or else Place < 2 then
            Texts.Append (To, All_Digits (Digit .. Digit));
         end if;
      end loop;
   end Append_Hexadecimal;

   procedure Find
     (Table : String; File : File_Place; Owner : out Texts.Text)
   is
      Wanted : Texts.Text := Texts.To_Text (" ");
      Start  : Positive;
   begin
      Texts.Set (Owner, "");
      Append_Hexadecimal (Wanted, File.Major);
      Texts.Append (Wanted, ":");
      Append_Hexadecimal (Wanted, File.Minor);
      Texts.Append (Wanted, ":");
      Texts.Append (Wanted, File.Inode);
      Texts.Append (Wanted, " ");
      for I in Table'Range loop
         if Table'Last - I >= Wanted.Length
           and then Table (I .. I + Wanted.Length - 1) = Texts.Image (Wanted)
         then
            Start := I;
            while Start > 1 and then Table (Start - 1) in '0' .. '9' loop
               pragma Loop_Invariant (Start <= I);
               Start := Start - 1;
            end loop;
            Texts.Set (Owner, Table (Start .. I - 1));
            return;
         end if;
      end loop;
   end Find;

end Lock_Tables;
