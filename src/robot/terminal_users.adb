--  SPDX-License-Identifier: GPL-3.0-or-later

package body Terminal_Users with SPARK_Mode is

   function Has_At
     (Text : String; First : Positive; Part : Texts.Text) return Boolean
   is (First <= Text'Last
       and then Text'Last - First >= Part.Length - 1
       and then Text (First .. First + Part.Length - 1) = Texts.Image (Part))
   with Pre => Text'First = 1
     and then Text'Last < Integer'Last
     and then Part.Length > 0;

   procedure Append
     (To : in out Texts.Text; Number : Interfaces.Unsigned_32)
   with Post => To.Length >= To.Length'Old
   is
      --  In decimal
   begin
      if Number < 2 ** 31 then
         Texts.Append (To, Integer (Number));
      end if;
   end Append;

   function Is_Console (Table : String; Device : Device_Number) return Boolean
   is
      Wanted : Texts.Text := Texts.To_Text (" ");
   begin
      Append (Wanted, Device.Major);
      Texts.Append (Wanted, ":");
      Append (Wanted, Device.Minor);
      Texts.Append (Wanted, (1 => Character'Val (10)));
      return (for some I in Table'Range => Has_At (Table, I, Wanted));
   end Is_Console;

   function Is_Of_Session (Stat : String; Device : Device_Number)
     return Boolean
   is
      Low    : constant Interfaces.Unsigned_32 := Device.Minor mod 256;
      Wanted : Texts.Text := Texts.To_Text (" ");
      Blanks : Natural range 0 .. 5 := 0;
   begin
      Append
        (Wanted,
         Low + 256 * Device.Major + 4_096 * (Device.Minor - Low));
      Texts.Append (Wanted, " ");
      for I in Stat'Range loop
         if Stat (I) = ')' then
            --  the name may have some, too: the last one counts
            Blanks := 0;
         elsif Stat (I) = ' ' and then Blanks < 5 then
            Blanks := Blanks + 1;
            --  the fifth word after the name
            if Blanks = 5
              and then Device.Major > 0  --  0: none
              and then Has_At (Stat, I, Wanted)
            then
               return True;
            end if;
         end if;
      end loop;
      return False;
   end Is_Of_Session;

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

   procedure Find_Lock
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
   end Find_Lock;

end Terminal_Users;
