--  SPDX-License-Identifier: GPL-3.0-or-later

with Texts;

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

end Terminal_Users;
