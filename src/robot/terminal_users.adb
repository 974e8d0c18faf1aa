--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Strings.Fixed; use Ada.Strings.Fixed;

package body Terminal_Users with SPARK_Mode is

   function Is_Console (Table : String; Number : Device) return Boolean is
      Wanted : Texts.Text := Texts.To_Text (" ");
   begin
      Texts.Append (Wanted, Number.Major);
      Texts.Append (Wanted, ":");
      Texts.Append (Wanted, Number.Minor);
      Texts.Append (Wanted, (1 => Character'Val (10)));
      return Index (Table, Texts.Image (Wanted)) > 0;
   end Is_Console;

   function Is_Of_Session (Stat : String; Number : Device) return Boolean is
      Wanted : Texts.Text := Texts.To_Text (" ");
      Blanks : Natural range 0 .. 5 := 0;
   begin
      Texts.Append
        (Wanted,
         Number.Minor mod 2 ** 8 + 2 ** 8 * Number.Major
         + 2 ** 20 * (Number.Minor / 2 ** 8));
      Texts.Append (Wanted, " ");
      --  the name may have a parenthesis, too: the last one counts
      for I in Index (Stat, ")", Ada.Strings.Backward) + 1 .. Stat'Last loop
         pragma Loop_Invariant (Blanks < 5);
         if Stat (I) = ' ' then
            Blanks := Blanks + 1;
            --  before the fifth word after the name
            if Blanks = 5 then
               return Number.Major > 0  --  0: none
                 and then
                   Index (Stat (I .. Stat'Last), Texts.Image (Wanted)) = I;
            end if;
         end if;
      end loop;
      return False;
   end Is_Of_Session;

   procedure Append_Hexadecimal (To : in out Texts.Text; Number : Natural) is
      --  Two digits or more
      All_Digits : constant String := "0123456789abcdef";
      Weights    : constant array (0 .. 4) of Positive :=
        (1, 16#10#, 16#100#, 16#1000#, 16#1_0000#);
      Left       : Natural;
      Digit      : Positive range 1 .. 16;
   begin
      for Place in reverse 0 .. 4 loop
         Left := Number / Weights (Place);
         Digit := Left mod 16 + 1;
         if Left > 0 or else Place < 2 then
            Texts.Append (To, All_Digits (Digit .. Digit));
         end if;
      end loop;
   end Append_Hexadecimal;

   procedure Find_Lock
     (Table : String; Locked : File; Owner : out Texts.Text)
   is
      Wanted : Texts.Text := Texts.To_Text (" ");
      Place  : Natural;
      Start  : Positive;
   begin
      Texts.Set (Owner, "");
      Append_Hexadecimal (Wanted, Locked.Place.Major);
      Texts.Append (Wanted, ":");
      Append_Hexadecimal (Wanted, Locked.Place.Minor);
      Texts.Append (Wanted, ":");
      Texts.Append (Wanted, Locked.Inode);
      Texts.Append (Wanted, " ");
      Place := Index (Table, Texts.Image (Wanted));
      if Place > 0 then
         Start := Place;
         while Start > 1 and then Table (Start - 1) in '0' .. '9' loop
            pragma Loop_Invariant (Start <= Place);
            Start := Start - 1;
         end loop;
         Texts.Set (Owner, Table (Start .. Place - 1));
      end if;
   end Find_Lock;

end Terminal_Users;
